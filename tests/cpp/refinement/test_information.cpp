#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <vector>

#include "refinement/information.h"
#include "refinement/refiner.h"
#include "refinement/shapes.h"

namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// One bumpy ball, scanned anew, with new points and new noise, as often as asked. The true pose
/// is the identity.
class Ball {
 public:
  explicit Ball(std::uint64_t state) {
    for (auto& bump : bumps_) {
      bumpy_direction(&state, bump);
      bump[3] = (bumpy_uniform(&state) < 0.5 ? -1 : 1) * (0.1 + 0.2 * bumpy_uniform(&state));
      bump[4] = 6.0 + 24.0 * bumpy_uniform(&state);
    }
  }

  emtr::Surface scan(double side, std::uint64_t seed, std::size_t n, double leaf) const {
    constexpr double radius = 1.4;  // of the ball with its bumps
    const double view[3] = {side, 0, 0.94};
    std::vector<double> p(3 * n);
    bumpy_scan(bumps_, view, &seed, n, p.data());
    emtr::Cloud cloud;
    for (std::size_t i = 0; i < n; ++i)
      emtr_test::push(cloud, static_cast<float>(p[3 * i] / radius),
                      static_cast<float>(p[3 * i + 1] / radius),
                      static_cast<float>(p[3 * i + 2] / radius));
    return emtr::downsample_surface(cloud, leaf);
  }

 private:
  double bumps_[BUMPY_BUMPS][5];
};

/// The small motion x with exp(x) pose = identity.
Vector6 error_of(const emtr::Rigid& pose) {
  const emtr::Rigid back = pose.inverse();
  const Eigen::AngleAxisd rotation{back.R};
  Vector6 x;
  x << rotation.angle() * rotation.axis(), back.t;
  return x;
}

/// The points of a scan, the leaf (some two and more points a cube) and whether both sides ask.
struct Case {
  std::size_t points;
  double leaf;
  bool both_ways;
};

class Information : public testing::TestWithParam<Case> {};

TEST_P(Information, IsTheInverseCovarianceOfRepeatedScans) {
  const auto [points, leaf, both_ways] = GetParam();
  emtr::LocalRefinementSettings settings;
  settings.both_ways = both_ways;
  constexpr int repeats = 40;
  // Mean squares of the errors by their forecast: of each motion, known to a sixth from so many
  // runs, and of all together.
  Vector6 single = Vector6::Zero();
  double together = 0;
  for (const std::uint64_t shape : {5u, 11u}) {
    const Ball ball(shape);
    for (std::uint64_t k = 0; k < repeats; ++k) {
      const emtr_test::Refiner refiner(ball.scan(0.35, 100 + k, points, leaf),
                                       ball.scan(-0.35, 900 + k, points, leaf), settings);
      emtr::LocalRefinement::Scratch scratch;
      const emtr::LocalRefinementResult out = (*refiner.local_refinement)(
          emtr_test::motion({0.3, -0.3, 0.2}, {0.005, 0, -0.005}), nullptr, scratch);
      ASSERT_NE(out.end, emtr::Termination::TooFewInliers);
      Matrix6 matrix;
      emtr::information(out, refiner.local_refinement->design_effect(out, scratch), matrix.data());
      EXPECT_EQ(matrix, Matrix6(matrix.transpose()));
      const Vector6 x = error_of(out.pose);
      const Vector6 forecast = matrix.inverse().diagonal();
      single += x.cwiseAbs2().cwiseQuotient(forecast) / (2 * repeats);
      together += x.dot(matrix * x) / (6 * 2 * repeats);
    }
  }
  EXPECT_GT(together, 1 / 1.3);
  EXPECT_LT(together, 1.3);
  for (int i = 0; i < 6; ++i) {
    EXPECT_GT(single[i], 1 / 1.5) << i;
    EXPECT_LT(single[i], 1.5) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Scans, Information,
                         testing::Values(Case{12000, 0.04, true}, Case{12000, 0.03, true},
                                         Case{12000, 0.03, false}, Case{60000, 0.018, true}));

TEST(DesignEffect, CountsPairsThatSayTheSame) {
  const Ball ball(5);
  emtr::LocalRefinementSettings one_way;
  one_way.both_ways = false;
  const auto effect = [&](const emtr::LocalRefinementSettings& settings) {
    const emtr_test::Refiner refiner(ball.scan(0.35, 1, 12000, 0.03),
                                     ball.scan(-0.35, 2, 12000, 0.03), settings);
    emtr::LocalRefinement::Scratch scratch;
    const emtr::LocalRefinementResult out = (*refiner.local_refinement)({}, nullptr, scratch);
    return refiner.local_refinement->design_effect(out, scratch);
  };
  const double once = effect(one_way), twice = effect({});
  EXPECT_GT(once, 1);
  EXPECT_LT(once, 2);
  EXPECT_GT(twice, 1.5 * once);  // each pair comes nearly twice
  EXPECT_LT(twice, 2.5 * once);
}

TEST(InformationOfNothing, IsZero) {
  double matrix[36];
  std::fill_n(matrix, 36, 7.0);
  emtr::information(emtr::LocalRefinementResult(), 1, matrix);
  for (const double v : matrix) EXPECT_EQ(v, 0);
}

}  // namespace
