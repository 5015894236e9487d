#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "pipeline/rival_results.h"
#include "support/clouds.h"

namespace {

using emtr::Result;

constexpr double kMinimum = 0.5;

class WeighRivals : public testing::Test {
 protected:
  /// A result whose pose moves the source along x, in the user's unit.
  static Result result(double x, double score, double confidence) {
    Result out;
    const double pose[16] = {1, 0, 0, x, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    std::copy_n(pose, 16, out.transformation);
    out.score = score;
    out.confidence = confidence;
    out.registered = confidence >= kMinimum;
    out.reason = out.registered ? EMTR_REASON_REGISTERED : EMTR_REASON_LOW_OVERLAP;
    return out;
  }

  void weigh(const Result& other, Result& best, bool small_is_source = true) const {
    emtr::weigh_rivals({&other}, {cloud_, small_is_source}, kMinimum, best);
  }

  const emtr_test::Pair pair_{62, 500, 1};
  const emtr::PreprocessedCloud cloud_{pair_.source(), "", 1};
  const double far_ = cloud_.radius;
};

TEST_F(WeighRivals, AnotherPlaceThatScoresAsWellMakesASureResultAmbiguous) {
  Result best = result(0, 0.16, 0.7);
  weigh(result(far_, 0.15, 0.35), best);
  EXPECT_FALSE(best.registered);
  EXPECT_EQ(best.reason, EMTR_REASON_AMBIGUOUS);
  EXPECT_LT(best.confidence, kMinimum);
  ASSERT_EQ(best.alternative_count, 1U);
  EXPECT_EQ(best.alternatives[0].transformation[3], far_);
  EXPECT_NEAR(best.score_gap, 0.01, 1e-12);
}

TEST_F(WeighRivals, TheSamePlaceIsNoRival) {
  for (const bool small_is_source : {true, false}) {
    Result best = result(0, 0.16, 0.7);
    weigh(result(far_ / 100, 0.15, 0.35), best, small_is_source);
    EXPECT_TRUE(best.registered);
    EXPECT_EQ(best.confidence, 0.7);
    EXPECT_EQ(best.alternative_count, 0U);
  }
}

TEST_F(WeighRivals, AFarLowerScoreIsNoRivalAndNeitherIsNone) {
  for (const double score : {0.02, 0.1, std::numeric_limits<double>::quiet_NaN()}) {
    Result best = result(0, 0.16, 0.7);
    weigh(result(far_, score, 0.35), best);
    EXPECT_TRUE(best.registered);
    EXPECT_EQ(best.reason, EMTR_REASON_REGISTERED);
  }
}

TEST_F(WeighRivals, AnAmbiguousResultIsLoweredOnlyOnce) {
  Result best = result(0, 0.16, 0.3);
  best.reason = EMTR_REASON_AMBIGUOUS;
  weigh(result(far_, 0.16, 0.3), best);
  EXPECT_EQ(best.confidence, 0.3);
  EXPECT_EQ(best.alternative_count, 1U);
}

TEST_F(WeighRivals, AStoppedResultStaysSo) {
  Result best = result(0, 0.16, 0.7);
  best.reason = EMTR_REASON_TIME_LIMIT;
  weigh(result(far_, 0.16, 0.3), best);
  EXPECT_EQ(best.reason, EMTR_REASON_TIME_LIMIT);
  EXPECT_FALSE(best.registered);
}

TEST_F(WeighRivals, AlternativesStayInTheOrderOfTheirScores) {
  Result best = result(0, 0.16, 0.7);
  weigh(result(far_, 0.13, 0.3), best);
  weigh(result(-far_, 0.15, 0.3), best);
  ASSERT_EQ(best.alternative_count, 2U);
  EXPECT_EQ(best.alternatives[0].score, 0.15);
  EXPECT_EQ(best.alternatives[1].score, 0.13);
}

}  // namespace
