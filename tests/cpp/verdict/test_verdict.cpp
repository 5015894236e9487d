#include <gtest/gtest.h>

#include <cmath>

#include "support/clouds.h"
#include "support/problems.h"
#include "verdict/verdict.h"

namespace {

class Verdict : public testing::Test {
 protected:
  emtr_test::Pair pair{21, 5000};
  emtr_test::ProblemPtr problem =
      emtr_test::problem_of(pair.source(), pair.target(), emtr::preset("paper"));
  emtr::Rigid truth = problem->pair.normalization.to_normalized(emtr::from_matrix(pair.pose()));

  emtr::Evolution with(std::vector<emtr::Rigid> poses) const {
    emtr::Evolution e;
    e.resolution = EMTR_RESOLUTION_DENSE;
    emtr::TaskAlpha::Scratch scratch;
    for (const auto& pose : poses)
      e.hypotheses.push_back(
          {pose, problem->alpha->evaluate(EMTR_RESOLUTION_DENSE, pose, scratch)});
    return e;
  }

  emtr::Verdict judge(const emtr::Evolution& e) const {
    return emtr::judge(e, e.hypotheses[e.best].pose, *problem->alpha,
                       problem->correspondences.size(), problem->settings);
  }
};

TEST_F(Verdict, AcceptsTheTruth) {
  const emtr::Verdict v = judge(with({truth}));
  EXPECT_TRUE(v.registered);
  EXPECT_EQ(v.reason, EMTR_REASON_REGISTERED);
  EXPECT_GT(v.inlier_ratio_source, 0.6);
  EXPECT_DOUBLE_EQ(v.fitness_gap, 1 - v.fitness);  // no other answer
}

TEST_F(Verdict, RefusesAPoseThatExplainsLittle) {
  emtr::Rigid off = truth;
  off.t[0] += 1.2;
  const emtr::Verdict v = judge(with({off}));
  EXPECT_FALSE(v.registered);
  EXPECT_EQ(v.reason, EMTR_REASON_LOW_OVERLAP);
}

TEST_F(Verdict, KnowsAnEquallyGoodOtherPose) {
  emtr::Evolution e = with({truth, truth});
  e.hypotheses[1].pose.t[0] += 0.2;
  e.hypotheses[1].fitness = e.hypotheses[0].fitness * 1.001;
  const emtr::Verdict v = judge(e);
  EXPECT_FALSE(v.registered);
  EXPECT_EQ(v.reason, EMTR_REASON_AMBIGUOUS);

  e.hypotheses[1].pose.t[0] = truth.t[0] + 0.01;  // the same answer
  EXPECT_TRUE(judge(e).registered);
}

TEST_F(Verdict, SaysWhenItWasStopped) {
  emtr::Evolution e = with({truth});
  e.stopped = true;
  EXPECT_EQ(judge(e).reason, EMTR_REASON_INTERRUPTED);
  EXPECT_FALSE(judge(e).registered);
}

TEST_F(Verdict, ScoresTheSameFromEitherStage) {
  emtr::Rigid other = truth;
  other.t[1] += 0.5;
  emtr::Evolution dense = with({truth, other}), sparse = dense;
  sparse.resolution = EMTR_RESOLUTION_SPARSE;
  sparse.hypotheses[1].fitness = 1;
  EXPECT_DOUBLE_EQ(judge(sparse).fitness_gap, judge(dense).fitness_gap);
}

}  // namespace
