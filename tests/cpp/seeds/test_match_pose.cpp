#include <gtest/gtest.h>

#include "seeds/match_pose.h"
#include "support/matches.h"

namespace {

using emtr_test::Matches;

std::vector<emtr::MatchPose> poses_of(const Matches& matches, int threads = 1) {
  return emtr::find_match_poses(matches.points, emtr::select_kernels(), threads);
}

TEST(MatchPose, HalfOfFiftyExactMatchesGiveThePoseToRounding) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Matches matches(25, 25, 0, seed);
    const auto poses = poses_of(matches);
    ASSERT_EQ(poses.size(), 1u);
    EXPECT_EQ(poses[0].inliers.size(), 25u);
    EXPECT_LT(matches.error(poses[0].pose), 1e-4);
    EXPECT_LT(poses[0].log_chance, -100);
  }
}

TEST(MatchPose, TenInAThousandAreFound) {
  int right = 0;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const Matches matches(10, 990, 0.01, seed);
    const auto poses = poses_of(matches);
    right += matches.error(poses[0].pose) < 5 && poses[0].log_chance < -2;
  }
  EXPECT_GE(right, 5);
}

TEST(MatchPose, OfMoreThanOneSubsetIsFound) {
  const Matches matches(100, 4900, 0.01);
  const auto poses = poses_of(matches);
  EXPECT_LT(matches.error(poses[0].pose), 2);
  EXPECT_NEAR(static_cast<double>(poses[0].inliers.size()), 100, 15);
}

TEST(MatchPose, MatchesThatLeadAnywhereSayNothing) {
  for (unsigned seed = 1; seed <= 5; ++seed)
    EXPECT_GT(poses_of(Matches(0, 200, 0, seed))[0].log_chance, -1);
}

TEST(MatchPose, ThreeAreAMinimum) {
  const Matches matches(3, 0, 0);
  const auto poses = poses_of(matches);
  EXPECT_LT(matches.error(poses[0].pose), 1e-3);
  EXPECT_LT(poses[0].log_chance, -8);
  const auto none = poses_of(Matches(0, 3, 0));
  EXPECT_GT(none[0].log_chance, -1);
}

TEST(MatchPose, ARivalIsTold) {
  Matches matches(30, 0, 0, 1);
  const Matches other(30, 0, 0, 2);
  for (std::size_t i = 0; i < 30; ++i)
    matches.append(emtr::point_of(other.points.p, i), emtr::point_of(other.points.q, i));
  const auto poses = poses_of(matches);
  ASSERT_EQ(poses.size(), 2u);
  EXPECT_EQ(poses[0].inliers.size(), 30u);
  EXPECT_EQ(poses[1].inliers.size(), 30u);
}

TEST(MatchPose, IsTheSameForAnyNumberOfThreadsAndAnyInstructionSet) {
  const Matches matches(20, 980, 0.01);
  const auto poses = poses_of(matches);
  const auto expect_same = [&](const std::vector<emtr::MatchPose>& others) {
    EXPECT_EQ(others[0].pose.R, poses[0].pose.R);
    EXPECT_EQ(others[0].pose.t, poses[0].pose.t);
    EXPECT_EQ(others[0].inliers, poses[0].inliers);
    EXPECT_EQ(others[0].log_chance, poses[0].log_chance);
  };
  expect_same(poses_of(matches, 3));
  for (std::size_t k = 0; const emtr::Kernels* kernels = emtr::kernels_at(k); ++k)
    if (emtr::can_run(*kernels)) expect_same(emtr::find_match_poses(matches.points, *kernels, 1));
}

TEST(MatchPose, APoseOfAnyOriginIsRated) {
  const Matches matches(20, 80, 0.001);
  const auto rated = emtr::rate_match_pose(matches.points, matches.pose);
  EXPECT_LT(rated.log_chance, -20);
  EXPECT_GE(rated.inliers.size(), 18u);
  emtr::Rigid wrong = matches.pose;
  wrong.t.x() += 0.7;
  EXPECT_GT(emtr::rate_match_pose(matches.points, wrong).log_chance, -1);
}

}  // namespace
