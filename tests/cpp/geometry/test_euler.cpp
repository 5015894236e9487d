#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "geometry/euler.h"

namespace {

using Matrix = Eigen::Matrix3d;

Matrix rotation(const double* angles) { return emtr::euler_to_rotation(angles); }

Matrix oracle(const double* a) {
  using Eigen::AngleAxisd;
  using Eigen::Vector3d;
  return (AngleAxisd(a[0], Vector3d::UnitZ()) * AngleAxisd(a[1], Vector3d::UnitY()) *
          AngleAxisd(a[2], Vector3d::UnitX()))
      .toRotationMatrix();
}

TEST(Euler, IsZYXForAnyAngles) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> far(-20, 20);
  for (int i = 0; i < 500; ++i) {
    const double angles[3] = {far(random), far(random), far(random)};
    EXPECT_LT((rotation(angles) - oracle(angles)).norm(), 1e-13);
  }
}

TEST(Euler, RoundTripsThroughCanonicalAngles) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> far(-20, 20);
  for (int i = 0; i < 500; ++i) {
    const double angles[3] = {far(random), i % 10 ? far(random) : M_PI / 2, far(random)};
    double back[3];
    emtr::rotation_to_euler(rotation(angles), back);
    EXPECT_LE(std::abs(back[1]), M_PI / 2);
    EXPECT_LT((rotation(back) - rotation(angles)).norm(), 1e-7);
  }
}

TEST(Euler, NearestAliasIsTheSameRotationAndNoFarther) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> far(-20, 20);
  for (int i = 0; i < 500; ++i) {
    const double a[3] = {far(random), far(random), far(random)};
    const double reference[3] = {far(random), far(random), far(random)};
    double alias[3];
    emtr::nearest_alias(a, reference, alias);
    EXPECT_LT((rotation(alias) - rotation(a)).norm(), 1e-12);
    for (int k = 0; k < 3; ++k) EXPECT_LE(std::abs(alias[k] - reference[k]), M_PI + 1e-12);
  }
  // Just across the seam: without the alias a mean would rotate the other way round.
  const double a[3] = {-3.1, 0, 0}, reference[3] = {3.1, 0, 0};
  double alias[3];
  emtr::nearest_alias(a, reference, alias);
  EXPECT_NEAR(alias[0], 2 * M_PI - 3.1, 1e-12);
}

TEST(Euler, ParticleIsAPose) {
  const double particle[6] = {0.3, -0.4, 0.5, 1, 2, 3};
  double back[6];
  emtr::encode(emtr::decode(particle), back);
  for (int k = 0; k < 6; ++k) EXPECT_NEAR(back[k], particle[k], 1e-14);
}

}  // namespace
