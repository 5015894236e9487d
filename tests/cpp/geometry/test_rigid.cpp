#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "geometry/rigid.h"

namespace {

using Matrix = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;

Matrix sample() {
  Matrix T = Matrix::Identity();
  T.topLeftCorner<3, 3>() = Eigen::Quaterniond(0.3, -0.5, 0.7, 0.2).normalized().matrix();
  T.topRightCorner<3, 1>() << 3, -4, 5;
  return T;
}

TEST(Rigid, InverseIsTheMatrixInverse) {
  const Matrix T = sample();
  double out[16];
  emtr::to_matrix(emtr::from_matrix(T.data()).inverse(), out);
  EXPECT_LT((Matrix(out) - T.inverse()).norm(), 1e-14);
}

TEST(Rigid, KnowsARigidMotion) {
  Matrix T = sample();
  EXPECT_TRUE(emtr::is_rigid(T.data()));
  Matrix mirrored = T;
  mirrored.col(0) *= -1;
  EXPECT_FALSE(emtr::is_rigid(mirrored.data()));
  Matrix scaled = T;
  scaled.topLeftCorner<3, 3>() *= 1.1;
  EXPECT_FALSE(emtr::is_rigid(scaled.data()));
  Matrix projective = T;
  projective(3, 0) = 0.1;
  EXPECT_FALSE(emtr::is_rigid(projective.data()));
  Matrix missing = T;
  missing(0, 3) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(emtr::is_rigid(missing.data()));
}

TEST(Rigid, RotationDistanceIsTheAngleAtEverySize) {
  for (const double angle : {1e-9, 1e-4, 0.5, 3.0, 3.14159}) {
    const Eigen::Matrix3d a = Eigen::Quaterniond(0.3, -0.5, 0.7, 0.2).normalized().matrix();
    const Eigen::Matrix3d b =
        a * Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, 3).normalized()).matrix();
    EXPECT_NEAR(emtr::rotation_distance(a, b) / angle, 1, 1e-6);
  }
}

TEST(Rigid, ProductsAndInverseAreThoseOfTheirMatrices) {
  const emtr::Rigid a{Eigen::Quaterniond(0.3, -0.5, 0.7, 0.2).normalized().toRotationMatrix(),
                      {1, -2, 3}},
      b{Eigen::Quaterniond(-0.8, 0.1, 0.4, 0.6).normalized().toRotationMatrix(), {-0.5, 4, 0.25}};
  const Eigen::Vector3d p(0.7, -1.1, 2.3);
  EXPECT_LT((a * p - (a.R * p + a.t)).norm(), 1e-15);
  EXPECT_LT((a.rotate(p) - a.R * p).norm(), 1e-15);
  EXPECT_LT(((a * b) * p - a * (b * p)).norm(), 1e-14);
  EXPECT_LT((a.inverse() * (a * p) - p).norm(), 1e-14);
}

}  // namespace
