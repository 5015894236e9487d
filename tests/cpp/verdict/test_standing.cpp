#include <gtest/gtest.h>

#include <cmath>

#include "candidates/modes.h"
#include "refinement/shapes.h"
#include "verdict/standing.h"

namespace {

using emtr::Candidate;
using emtr::Standing;

/// Candidates about the z axis, 20 degrees apart, with these scores.
std::vector<Candidate> ranked(const std::vector<double>& scores) {
  std::vector<Candidate> out;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    Candidate c;
    c.pose = emtr_test::motion({0, 0, 20.0 * static_cast<double>(i)}, {0, 0, 0});
    c.score = scores[i];
    out.push_back(c);
  }
  return out;
}

Candidate at(double degrees, double score, double shift = 0) {
  Candidate c;
  c.pose = emtr_test::motion({degrees, 0, 0}, {shift, 0, 0});
  c.score = score;
  return c;
}

TEST(Standing, TheGapIsToTheBestClearlyDifferentCandidate) {
  const Standing s =
      emtr::stand({at(0, 0.7), at(6, 0.65), at(0, 0.6, 0.1), at(40, 0.5), at(80, 0.4)});
  EXPECT_DOUBLE_EQ(s.gap, 0.7 - 0.5);
  ASSERT_EQ(s.others.size(), 2u);
  EXPECT_EQ(s.others[0].score, 0.5);
  EXPECT_EQ(s.others[1].score, 0.4);
}

TEST(Standing, AShiftAloneMakesAnotherAnswerToo) {
  EXPECT_DOUBLE_EQ(emtr::stand({at(0, 0.7), at(0, 0.6, 0.2)}).gap, 0.7 - 0.6);
}

TEST(Standing, WithoutOthersTheGapIsTheScore) {
  const Standing s = emtr::stand({at(0, 0.6), at(5, 0.5)});
  EXPECT_EQ(s.gap, 0.6);
  EXPECT_TRUE(s.others.empty());
}

TEST(Standing, OthersBelowNothingLeaveTheGapAtTheScore) {
  // A score below zero is as good as none: it must not make the best look better.
  EXPECT_EQ(emtr::stand({at(0, 0.3), at(90, -0.8)}).gap, 0.3);
}

TEST(Standing, OthersAreDistinctBestFirstAndTenAtMost) {
  std::vector<Candidate> all;
  for (int i = 0; i < 60; ++i) all.push_back(at(6.0 * i, 0.7 - 0.01 * i));
  const Standing s = emtr::stand(all);
  ASSERT_EQ(s.others.size(), 10u);
  for (std::size_t i = 0; i < s.others.size(); ++i) {
    EXPECT_FALSE(emtr::within(s.others[i].pose, all[0].pose, emtr::kMode));
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_FALSE(emtr::within(s.others[i].pose, s.others[j].pose, emtr::kMode));
      EXPECT_LE(s.others[i].score, s.others[j].score);
    }
  }
}

TEST(Standing, ConfidenceIsAShareThatGrowsWithScoreAndGap) {
  double of_score = -1;
  for (const double score : {-1.0, -0.3, 0.0, 0.2, 0.4, 0.6, 0.8, 1.0}) {
    const double c = emtr::stand(ranked({score, score - 0.05})).confidence;
    EXPECT_GE(c, 0);
    EXPECT_LE(c, 1);
    EXPECT_GT(c, of_score) << score;
    of_score = c;
  }
  double of_gap = -1;
  for (const double gap : {0.0, 0.01, 0.05, 0.1, 0.2, 0.3}) {
    const double c = emtr::stand(ranked({0.3, 0.3 - gap})).confidence;
    EXPECT_GE(c, 0);
    EXPECT_LE(c, 1);
    EXPECT_GT(c, of_gap) << gap;
    of_gap = c;
  }
}

TEST(Standing, ConfidenceTellsGoodFromBad) {
  EXPECT_GT(emtr::stand(ranked({0.7, 0.1})).confidence, 0.95);
  EXPECT_LT(emtr::stand(ranked({0.1, 0.09})).confidence, 0.1);
  EXPECT_LT(emtr::stand(ranked({-2})).confidence, 0.05);
}

class Reason : public testing::Test {
 protected:
  emtr_reason reason(const std::vector<double>& scores, bool slides = false,
                     std::size_t correspondences = 100) const {
    const auto all = ranked(scores);
    return emtr::reason(all.front(), emtr::stand(all), slides, correspondences, settings);
  }
  emtr::Settings settings = emtr::preset("default");
};

TEST_F(Reason, Registered) {
  EXPECT_EQ(reason({0.7, 0.1}), EMTR_REASON_REGISTERED);
  EXPECT_EQ(reason({0.7, 0.1}, false, 0), EMTR_REASON_REGISTERED);  // however it was found
}

TEST_F(Reason, Degenerate) { EXPECT_EQ(reason({0.7, 0.1}, true), EMTR_REASON_DEGENERATE); }

TEST_F(Reason, Ambiguous) {
  EXPECT_EQ(reason({0.3, 0.295}), EMTR_REASON_AMBIGUOUS);
  EXPECT_EQ(reason({0.3, 0.295}, true), EMTR_REASON_AMBIGUOUS);
}

TEST_F(Reason, ARivalOfPosesThatMeanNothingIsNone) {
  EXPECT_EQ(reason({0.1, 0.099}), EMTR_REASON_LOW_OVERLAP);
}

TEST_F(Reason, LowOverlap) {
  settings.minimum_confidence = 0.99;
  EXPECT_EQ(reason({0.2, 0.1}), EMTR_REASON_LOW_OVERLAP);  // the rival is no rival
  EXPECT_EQ(reason({0.2}), EMTR_REASON_LOW_OVERLAP);       // there is none
  EXPECT_EQ(reason({-0.1, -0.11}), EMTR_REASON_LOW_OVERLAP);
}

TEST_F(Reason, FewMatches) {
  EXPECT_EQ(reason({0.1, 0.05}, false, 9), EMTR_REASON_FEW_MATCHES);
  EXPECT_EQ(reason({0.1, 0.05}, false, 10), EMTR_REASON_LOW_OVERLAP);
  EXPECT_EQ(reason({0.3, 0.295}, false, 3), EMTR_REASON_FEW_MATCHES);
}

TEST_F(Reason, FollowsTheConfidenceAskedFor) {
  const double confidence = emtr::stand(ranked({0.4, 0.3})).confidence;
  settings.minimum_confidence = confidence;
  EXPECT_EQ(reason({0.4, 0.3}), EMTR_REASON_REGISTERED);
  settings.minimum_confidence = std::nextafter(confidence, 1.0);
  EXPECT_NE(reason({0.4, 0.3}), EMTR_REASON_REGISTERED);
}

}  // namespace
