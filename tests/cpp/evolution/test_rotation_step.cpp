#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "evolution/rotation_step.h"
#include "geometry/euler.h"
#include "geometry/rigid.h"
#include "geometry/rotation_vector.h"

namespace {

using Rotation = Eigen::Matrix3d;

struct Angles {
  double v[3];
  Rotation R() const { return emtr::euler_to_rotation(v); }
};

class RotationStep : public testing::Test {
 protected:
  Angles any() {
    std::uniform_real_distribution<double> angle(-7, 7);  // beyond 2 pi, as particles fly on
    return {{angle(random), angle(random), angle(random)}};
  }
  /// By the series of the matrix exponential, which knows nothing of quaternions.
  static Rotation exponential(const double* vector) {
    const double x = vector[0] / 1024, y = vector[1] / 1024, z = vector[2] / 1024;
    Rotation skew, out = Rotation::Identity(), term = Rotation::Identity();
    skew << 0, -z, y, z, 0, -x, -y, x, 0;
    for (int k = 1; k < 12; ++k) {
      term = term * skew / k;
      out += term;
    }
    for (int k = 0; k < 10; ++k) out = (out * out).eval();
    return out;
  }
  std::mt19937_64 random{7};
};

TEST_F(RotationStep, TheVectorBetweenLeadsFromOneToTheOtherByTheShortestWay) {
  for (int k = 0; k < 500; ++k) {
    const Angles from = any(), to = any();
    double vector[3];
    emtr::rotation_between(from.v, to.v, vector);
    EXPECT_LT((exponential(vector) * from.R() - to.R()).norm(), 1e-9);
    const double length = Eigen::Vector3d::Map(vector).norm();
    EXPECT_LE(length, M_PI + 1e-12);
    EXPECT_NEAR(length, emtr::rotation_distance(from.R(), to.R()), 1e-7);
  }
}

TEST_F(RotationStep, NothingLiesBetweenOneRotationAndItself) {
  const Angles here{{0.4, -1.1, 2.5}}, alias{{0.4 + M_PI, M_PI + 1.1, 2.5 - M_PI}};
  double vector[3];
  emtr::rotation_between(here.v, here.v, vector);
  EXPECT_LT(Eigen::Vector3d::Map(vector).norm(), 1e-7);
  emtr::rotation_between(here.v, alias.v, vector);
  EXPECT_LT(Eigen::Vector3d::Map(vector).norm(), 1e-7);
}

TEST_F(RotationStep, ARotationIsTheExponentialOnTheLeft) {
  std::uniform_real_distribution<double> component(-4, 4);
  for (int k = 0; k < 500; ++k) {
    const Angles before = any();
    const double vector[3] = {component(random), component(random), component(random)};
    Angles after = before;
    emtr::rotate_angles(after.v, vector);
    EXPECT_LT((after.R() - exponential(vector) * before.R()).norm(), 1e-9);
    EXPECT_LE(std::abs(after.v[0]), M_PI);
    EXPECT_LE(std::abs(after.v[1]), M_PI / 2);
    EXPECT_LE(std::abs(after.v[2]), M_PI);
  }
}

TEST_F(RotationStep, GoesThroughTheGimbalLock) {
  // Two angles mean the same there, and still a step is a step.
  const Angles lock{{0.3, M_PI / 2, -0.8}};
  for (const double step : {0.0, 1e-9, 1e-3, 1.0}) {
    const double vector[3] = {step, -step, step / 2};
    Angles after = lock;
    emtr::rotate_angles(after.v, vector);
    // Next to the lock angles keep half of their digits.
    EXPECT_LT((after.R() - exponential(vector) * lock.R()).norm(), 1e-7) << step;
    double back[3];
    emtr::rotation_between(lock.v, after.v, back);
    EXPECT_LT((Eigen::Vector3d::Map(back) - Eigen::Vector3d::Map(vector)).norm(), 1e-7) << step;
  }
}

TEST(RotationVector, LogarithmUndoesTheExponential) {
  for (const double length : {0.0, 1e-12, 1e-4, 1.0, 3.1}) {
    const Eigen::Vector3d vector = length * Eigen::Vector3d(2, -1, 2) / 3;
    EXPECT_LT((emtr::logarithm(emtr::exponential(vector)) - vector).norm(), 1e-12) << length;
  }
  // Longer than pi: the other way round is shorter.
  const Eigen::Vector3d axis = Eigen::Vector3d(2, -1, 2) / 3;
  EXPECT_LT((emtr::logarithm(emtr::exponential(4 * axis)) - (4 - 2 * M_PI) * axis).norm(), 1e-12);
}

}  // namespace
