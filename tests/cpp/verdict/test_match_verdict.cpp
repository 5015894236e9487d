#include <emtr/emtr.h>
#include <gtest/gtest.h>

#include <numeric>

#include "settings/settings.h"
#include "support/matches.h"
#include "verdict/match_verdict.h"

namespace {

using emtr_test::Matches;

emtr::MatchPose pose_of_all(const Matches& matches, double noise) {
  emtr::MatchPose out;
  out.pose = matches.pose;
  out.noise = noise;
  out.inliers.resize(matches.points.size());
  std::iota(out.inliers.begin(), out.inliers.end(), 0u);
  return out;
}

emtr::Settings settings() { return emtr::preset("default"); }

TEST(MatchVerdict, HangsOnChanceAndOnTheRival) {
  emtr::MatchPose sure, doubtful;
  sure.log_chance = -20;
  doubtful.log_chance = 0;
  const auto registered = emtr::judge_matches({sure}, false, settings());
  EXPECT_EQ(registered.reason, EMTR_REASON_REGISTERED);
  EXPECT_EQ(registered.confidence, 0.999999);
  EXPECT_EQ(emtr::judge_matches({sure}, true, settings()).reason, EMTR_REASON_DEGENERATE);
  EXPECT_EQ(emtr::judge_matches({sure, sure}, false, settings()).reason, EMTR_REASON_AMBIGUOUS);
  const auto few = emtr::judge_matches({doubtful}, false, settings());
  EXPECT_EQ(few.reason, EMTR_REASON_FEW_MATCHES);
  EXPECT_LT(few.confidence, 0.1);
}

TEST(MatchVerdict, MatchesInSpaceLeaveNoDirectionOpen) {
  const Matches matches(20, 0, 0.001);
  const auto found = emtr::constraints_of(matches.points, pose_of_all(matches, 0.001), nullptr);
  EXPECT_TRUE(found.succeeded);
  EXPECT_EQ(found.unconstrained, 0);
  EXPECT_NEAR(found.rmse, 0.0017, 0.0005);
  EXPECT_NEAR(found.information[21] / (20 / 1e-6), 1, 1e-9);  // a translation, by twenty matches
}

TEST(MatchVerdict, MatchesOnALineLeaveTheRotationAboutItOpen) {
  for (const double noise : {0.0, 0.001}) {
    Matches matches(0, 0, 0);
    for (int i = 0; i < 20; ++i) {
      const Eigen::Vector3d p = Eigen::Vector3d(0.3, 0.1, -0.2) * (0.1 * i - 1);
      matches.append(p, matches.pose * p);
    }
    const auto found = emtr::constraints_of(matches.points, pose_of_all(matches, noise), nullptr);
    EXPECT_EQ(found.unconstrained, 1) << noise;
    const double* axis = found.hessian_spectrum.eigenvectors[0];
    const Eigen::Vector3d line = matches.pose.rotate(Eigen::Vector3d(0.3, 0.1, -0.2).normalized());
    EXPECT_NEAR(std::abs(Eigen::Vector3d(axis[0], axis[1], axis[2]).dot(line)), 1, 1e-3);
  }
}

}  // namespace
