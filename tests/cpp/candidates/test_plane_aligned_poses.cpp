#include <gtest/gtest.h>

#include <algorithm>

#include "candidates/plane_aligned_poses.h"
#include "candidates/scene.h"
#include "candidates/yard.h"

namespace {

using emtr::Rigid;
using emtr::Surface;
using emtr::SurfacePair;

constexpr std::size_t kMost = 48;

std::vector<Rigid> poses_of(const Surface& source, const Surface& target, int threads = 1) {
  const SurfacePair surfaces(source, target, {}, {}, emtr::select_kernels());
  std::vector<Rigid> out;
  emtr::ThreadTeam::with(threads, [&](emtr::ThreadTeam& team) {
    out = emtr::plane_aligned_poses(surfaces, kMost, emtr::select_kernels(), team);
  });
  return out;
}

/// What stands left of 0.3 onto what stands right of -0.3.
TEST(PlaneAlignedPoses, FindAYardOfWhichTwoScansShareLittle) {
  for (const Eigen::Vector3d& degrees :
       {Eigen::Vector3d(0, 0, 75), Eigen::Vector3d(120, 40, -100), Eigen::Vector3d(180, 0, 10)}) {
    const Rigid truth = emtr_test::motion(degrees, {0.2, -0.1, 0.15});
    const auto poses = poses_of(emtr_test::yard(-1, 0.3, 0),
                                emtr_test::moved(emtr_test::yard(-0.3, 1, 0.4), truth));
    EXPECT_TRUE(std::any_of(poses.begin(), poses.end(), [&](const Rigid& pose) {
      return is_same_pose(pose, truth, {2 * emtr::kDegree, 0.03});
    })) << degrees.transpose();
  }
}

TEST(PlaneAlignedPoses, AreRigidAndFewAndTheSameForAnyThreads) {
  const Surface source = emtr_test::yard(-1, 0.3, 0), target = emtr_test::yard(-0.3, 1, 0.4);
  const auto poses = poses_of(source, target), again = poses_of(source, target, 3);
  ASSERT_FALSE(poses.empty());
  EXPECT_LE(poses.size(), kMost);
  ASSERT_EQ(poses.size(), again.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    double T[16];
    to_matrix(poses[i], T);
    EXPECT_TRUE(emtr::is_rigid(T));
    EXPECT_TRUE(emtr_test::same_bits(poses[i], again[i]));
  }
}

}  // namespace
