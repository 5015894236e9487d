#include <gtest/gtest.h>

#include "geometry/pose_distance.h"
#include "refinement/shapes.h"

namespace {

using emtr::is_same_pose;
using emtr::kDistinctPose;
using emtr::kDuplicatePose;
using emtr::suppress_non_maxima;
using emtr_test::motion;

TEST(SamePose, IsLimitedByTheAngle) {
  const emtr::Rigid a = motion({0, 0, 120}, {0.1, 0.2, 0.3});
  EXPECT_TRUE(is_same_pose(a, a, {0, 0}));
  EXPECT_TRUE(is_same_pose(a, motion({0, 0, 129.9}, {0.1, 0.2, 0.3}), kDistinctPose));
  EXPECT_FALSE(is_same_pose(a, motion({0, 0, 130.1}, {0.1, 0.2, 0.3}), kDistinctPose));
  EXPECT_TRUE(is_same_pose(a, motion({0, 0, 117.1}, {0.1, 0.2, 0.3}), kDuplicatePose));
  EXPECT_FALSE(is_same_pose(a, motion({0, 0, 116.9}, {0.1, 0.2, 0.3}), kDuplicatePose));
}

TEST(SamePose, IsLimitedByTheTranslation) {
  const emtr::Rigid a = motion({10, 20, 30}, {0.1, 0.2, 0.3});
  EXPECT_TRUE(is_same_pose(a, motion({10, 20, 30}, {0.1, 0.349, 0.3}), kDistinctPose));
  EXPECT_FALSE(is_same_pose(a, motion({10, 20, 30}, {0.1, 0.351, 0.3}), kDistinctPose));
  // As long as the straight way, not as the longest of its coordinates.
  EXPECT_FALSE(is_same_pose(a, motion({10, 20, 30}, {0.2, 0.3, 0.4}), kDistinctPose));
  EXPECT_TRUE(is_same_pose(a, motion({10, 20, 30}, {0.071, 0.2, 0.3}), kDuplicatePose));
  EXPECT_FALSE(is_same_pose(a, motion({10, 20, 30}, {0.069, 0.2, 0.3}), kDuplicatePose));
}

TEST(SamePose, HalfATurnIsFarWhicheverWayItGoes) {
  const emtr::Rigid a = motion({0, 179, 0}, {0, 0, 0}), b = motion({0, -179, 0}, {0, 0, 0});
  EXPECT_TRUE(is_same_pose(a, b, kDuplicatePose));  // two degrees
  EXPECT_FALSE(is_same_pose(a, emtr::Rigid{}, kDistinctPose));
}

TEST(SamePose, GoesBothWaysAndADuplicateIsNotDistinct) {
  emtr_test::Draw draw(5);
  int duplicates = 0, same = 0;
  for (int i = 0; i < 300; ++i) {
    const auto pose = [&] {
      return motion(draw.uniform(0, 8) * draw.direction(), draw.uniform(0, 0.1) * draw.direction());
    };
    const emtr::Rigid a = pose(), b = pose();
    EXPECT_EQ(is_same_pose(a, b, kDistinctPose), is_same_pose(b, a, kDistinctPose));
    EXPECT_EQ(is_same_pose(a, b, kDuplicatePose), is_same_pose(b, a, kDuplicatePose));
    if (is_same_pose(a, b, kDuplicatePose)) {
      EXPECT_TRUE(is_same_pose(a, b, kDistinctPose));
    }
    duplicates += is_same_pose(a, b, kDuplicatePose);
    same += is_same_pose(a, b, kDistinctPose);
  }
  EXPECT_GT(duplicates, 0);
  EXPECT_GT(same, duplicates);
  EXPECT_LT(same, 300);
}

/// Returns which rotations about z, by so many degrees, are kept.
std::vector<int> left(const std::vector<int>& degrees, std::size_t maximum) {
  std::vector<emtr::Rigid> poses;
  for (const int angle : degrees) poses.push_back(motion({0, 0, angle * 1.0}, {0, 0, 0}));
  std::vector<int> out;
  for (const emtr::Rigid& pose : suppress_non_maxima(poses, kDistinctPose, maximum))
    for (std::size_t i = 0; i < poses.size(); ++i)
      if (is_same_pose(pose, poses[i], {0, 0})) {
        out.push_back(degrees[i]);
        break;
      }
  return out;
}

TEST(SuppressNonMaxima, KeepsTheFirstOfEachInTheOrderGiven) {
  EXPECT_EQ(left({40, 0, 45, 90, 5, 60}, 9), (std::vector<int>{40, 0, 90, 60}));
  // What was left out itself keeps nothing out: 16 is near 8, which is near 0.
  EXPECT_EQ(left({0, 8, 16, 24, 32}, 9), (std::vector<int>{0, 16, 32}));
}

TEST(SuppressNonMaxima, KeepsNoMoreThanAskedFor) {
  EXPECT_EQ(left({0, 5, 30, 60, 90}, 2), (std::vector<int>{0, 30}));
  EXPECT_EQ(left({0, 30}, 0), std::vector<int>{});
  EXPECT_EQ(left({}, 3), std::vector<int>{});
}

}  // namespace
