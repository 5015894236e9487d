#include <gtest/gtest.h>

#include <cmath>

#include "geometry/euler.h"
#include "seeds/procrustes.h"

namespace {

using Eigen::Vector3d;

const Vector3d kPoints[5] = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0.3, 0.1, 1}, {-1, 0.5, 0.2}};

emtr::Rigid some_pose() {
  const double particle[6] = {2.1, -0.7, 0.4, 3, -1, 0.5};
  return emtr::decode(particle);
}

void expect_same(const emtr::Rigid& a, const emtr::Rigid& b, double tolerance) {
  EXPECT_LT(emtr::rotation_distance(a.R, b.R), tolerance);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(a.t[i], b.t[i], tolerance);
}

TEST(Procrustes, FindsThePose) {
  emtr::Procrustes sums;
  for (const Vector3d& p : kPoints) sums.add(p, some_pose() * p);
  expect_same(sums.pose(), some_pose(), 1e-12);
}

TEST(Procrustes, WeightZeroCountsForNothing) {
  emtr::Procrustes sums;
  for (const Vector3d& p : kPoints) sums.add(p, some_pose() * p, 0.5);
  sums.add(kPoints[0], Vector3d(9, 9, 9), 0);
  EXPECT_EQ(sums.weight(), 2.5);
  expect_same(sums.pose(), some_pose(), 1e-12);
}

TEST(Procrustes, PointsInAPlaneGiveNoReflection) {
  emtr::Procrustes sums;
  for (const Vector3d& p : kPoints) {
    const Vector3d flat(p.x(), p.y(), 0);
    sums.add(flat, some_pose() * flat);
  }
  expect_same(sums.pose(), some_pose(), 1e-12);
}

TEST(Procrustes, MirroredPointsStillGiveARotation) {
  emtr::Procrustes sums;
  for (const Vector3d& p : kPoints) sums.add(p, Vector3d(-p.x(), p.y(), p.z()));
  double T[16];
  emtr::to_matrix(sums.pose(), T);
  EXPECT_TRUE(emtr::is_rigid(T));
}

}  // namespace
