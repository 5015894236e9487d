#include <gtest/gtest.h>

#include <cmath>

#include "seeds/procrustes.h"
#include "geometry/euler.h"

namespace {

const double kPoints[5][3] = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0.3, 0.1, 1}, {-1, 0.5, 0.2}};

emtr::Rigid some_pose() {
  const double particle[6] = {2.1, -0.7, 0.4, 3, -1, 0.5};
  return emtr::decode(particle);
}

void moved(const emtr::Rigid& pose, const double p[3], double q[3]) {
  for (int a = 0; a < 3; ++a)
    q[a] = pose.R(a, 0) * p[0] + pose.R(a, 1) * p[1] + pose.R(a, 2) * p[2] + pose.t[a];
}

void expect_same(const emtr::Rigid& a, const emtr::Rigid& b, double tolerance) {
  EXPECT_LT(emtr::rotation_distance(a.R, b.R), tolerance);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(a.t[i], b.t[i], tolerance);
}

TEST(Procrustes, FindsThePose) {
  emtr::Procrustes sums;
  for (const auto& p : kPoints) {
    double q[3];
    moved(some_pose(), p, q);
    sums.add(p, q);
  }
  expect_same(sums.pose(), some_pose(), 1e-12);
}

TEST(Procrustes, WeightZeroCountsForNothing) {
  emtr::Procrustes sums;
  for (const auto& p : kPoints) {
    double q[3];
    moved(some_pose(), p, q);
    sums.add(p, q, 0.5);
  }
  const double far[3] = {9, 9, 9};
  sums.add(kPoints[0], far, 0);
  EXPECT_EQ(sums.weight(), 2.5);
  expect_same(sums.pose(), some_pose(), 1e-12);
}

TEST(Procrustes, PointsInAPlaneGiveNoReflection) {
  emtr::Procrustes sums;
  for (const auto& p : kPoints) {
    const double flat[3] = {p[0], p[1], 0};
    double q[3];
    moved(some_pose(), flat, q);
    sums.add(flat, q);
  }
  expect_same(sums.pose(), some_pose(), 1e-12);
}

TEST(Procrustes, MirroredPointsStillGiveARotation) {
  emtr::Procrustes sums;
  for (const auto& p : kPoints) {
    const double q[3] = {-p[0], p[1], p[2]};
    sums.add(p, q);
  }
  double T[16];
  emtr::to_matrix(sums.pose(), T);
  EXPECT_TRUE(emtr::is_rigid(T));
}

}  // namespace
