#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <vector>

#include "polisher.h"
#include "refinement/information.h"
#include "shapes.h"

namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// One bumpy ball, scanned anew, with new points and new noise, as often as asked. The true pose
/// is the identity.
class Ball {
 public:
  Ball() {
    std::uint64_t state = 5;
    for (auto& bump : bumps_) {
      bumpy_direction(&state, bump);
      bump[3] = (bumpy_uniform(&state) < 0.5 ? -1 : 1) * (0.1 + 0.2 * bumpy_uniform(&state));
      bump[4] = 6.0 + 24.0 * bumpy_uniform(&state);
    }
  }

  emtr::Surface scan(double side, std::uint64_t seed, double leaf) const {
    constexpr std::size_t n = 12000;
    constexpr double radius = 1.4;  // of the ball with its bumps
    const double view[3] = {side, 0, 0.94};
    std::vector<double> p(3 * n);
    bumpy_scan(bumps_, view, &seed, n, p.data());
    emtr::Cloud cloud;
    for (std::size_t i = 0; i < n; ++i)
      emtr_test::push(cloud, static_cast<float>(p[3 * i] / radius),
                      static_cast<float>(p[3 * i + 1] / radius),
                      static_cast<float>(p[3 * i + 2] / radius));
    return emtr::thin_surface(cloud, leaf);
  }

 private:
  double bumps_[BUMPY_BUMPS][5];
};

/// The small motion x with exp(x) pose = identity.
Vector6 error_of(const emtr::Rigid& pose) {
  const emtr::Rigid back = pose.inverse();
  using Rotation = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  const Eigen::AngleAxisd turn{Eigen::Matrix3d(Eigen::Map<const Rotation>(back.R))};
  Vector6 x;
  x << turn.angle() * turn.axis(), Eigen::Vector3d::Map(back.t);
  return x;
}

class Information : public testing::TestWithParam<bool> {};

TEST_P(Information, IsTheInverseCovarianceOfRepeatedScans) {
  constexpr int repeats = 30;
  constexpr double leaf = 0.03;
  const Ball ball;
  emtr::Polish settings;
  settings.both_ways = GetParam();
  Matrix6 seen = Matrix6::Zero(), said = Matrix6::Zero();
  double normalised = 0;
  for (std::uint64_t k = 0; k < repeats; ++k) {
    const emtr_test::Polisher polisher(ball.scan(0.35, 100 + k, leaf),
                                       ball.scan(-0.35, 900 + k, leaf), settings);
    const emtr::Polished out = polisher(emtr_test::motion({0.3, -0.3, 0.2}, {0.005, 0, -0.005}));
    ASSERT_NE(out.end, emtr::PolishEnd::TooFewInliers);
    Matrix6 matrix;
    emtr::information(out, matrix.data());
    EXPECT_EQ(matrix, Matrix6(matrix.transpose()));
    const Vector6 x = error_of(out.pose);
    seen += x * x.transpose() / repeats;
    said += matrix.inverse() / repeats;
    normalised += x.dot(matrix * x) / (6.0 * repeats);
  }
  EXPECT_GT(normalised, 1 / 2.5);
  EXPECT_LT(normalised, 2.5);
  for (int i = 0; i < 6; ++i) {
    EXPECT_GT(seen(i, i) / said(i, i), 1.0 / 3) << i;
    EXPECT_LT(seen(i, i) / said(i, i), 3) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Ways, Information, testing::Bool(),
                         [](const auto& both) { return both.param ? "both" : "one"; });

TEST(InformationOfNothing, IsZero) {
  double matrix[36];
  std::fill_n(matrix, 36, 7.0);
  emtr::information(emtr::Polished(), matrix);
  for (const double v : matrix) EXPECT_EQ(v, 0);
}

}  // namespace
