#include <gtest/gtest.h>

#include "seeds/truncated_fit.h"
#include "support/matches.h"

namespace {

using emtr_test::Matches;

emtr::Rigid near(const emtr::Rigid& pose) {
  emtr::Rigid out = pose;
  out.t += Eigen::Vector3d(0.01, -0.01, 0.005);
  return out;
}

TEST(TruncatedFit, ExactMatchesGiveThePoseToRounding) {
  const Matches matches(25, 25, 0);
  const auto fit = emtr::truncated_fit(matches.points, near(matches.pose), 0.03);
  EXPECT_LT(matches.error(fit.pose), 1e-4);
  EXPECT_LT((fit.pose.t - matches.pose.t).norm(), 1e-6);
}

TEST(TruncatedFit, EstimatesTheNoise) {
  const Matches matches(300, 100, 0.01);
  const auto fit = emtr::truncated_fit(matches.points, near(matches.pose), 0.02);
  EXPECT_NEAR(fit.noise, 0.01, 0.0015);
  EXPECT_NEAR(fit.threshold, 4.03 * fit.noise, 0.004);
  EXPECT_LT(matches.error(fit.pose), 0.5);
}

}  // namespace
