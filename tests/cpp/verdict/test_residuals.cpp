#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "refinement/shapes.h"
#include "util/error.h"
#include "verdict/residuals.h"

namespace {

using Points = std::vector<Eigen::Vector3d>;

Points drawn(std::uint64_t seed, std::size_t n, const Eigen::Vector3d& center, double size) {
  emtr_test::Draw draw(seed);
  Points out(n);
  for (auto& p : out)
    p = center +
        size * Eigen::Vector3d(draw.uniform(-1, 1), draw.uniform(-1, 1), 0.2 * draw.uniform(-1, 1));
  return out;
}

emtr_cloud view(const Points& points) { return {points.data(), points.size(), 0, EMTR_FLOAT64}; }

/// Distance of every point to the nearest of the others, by looking at all.
std::vector<double> by_hand(const Points& points, const emtr::Rigid& pose, const Points& others) {
  const Eigen::Matrix3d& R = pose.R;
  std::vector<double> out;
  for (const auto& p : points) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& q : others) least = std::min(least, (R * p + pose.t - q).norm());
    out.push_back(least);
  }
  return out;
}

TEST(Residuals, AreTheDistancesToTheNearestPointBothWays) {
  for (const double unit : {1e-3, 1.0, 1e3}) {
    const Eigen::Vector3d far(4e5, 5e6, 100);  // map coordinates
    const Points target = drawn(1, 900, unit * far, unit);
    Points source = drawn(2, 700, {0, 0, 0}, 1.3 * unit);
    const emtr::Rigid pose =
        emtr_test::motion({10, 50, -70}, unit * (far + Eigen::Vector3d(0.5, 0, 0.1)));
    std::vector<double> of_source(source.size()), of_target(target.size());
    emtr::residuals(view(source), view(target), {1, pose}, 2, of_source.data(), of_target.data());
    const auto expected = by_hand(source, pose, target),
               others = by_hand(target, pose.inverse(), source);
    for (std::size_t i = 0; i < source.size(); ++i)
      EXPECT_NEAR(of_source[i], expected[i], 1e-6 * unit) << i;
    for (std::size_t i = 0; i < target.size(); ++i)
      EXPECT_NEAR(of_target[i], others[i], 2e-6 * unit) << i;
  }
}

TEST(Residuals, OfAScaledSourceAreInTheTargetsUnit) {
  const Points target = drawn(8, 500, {0, 0, 0}, 1), source = drawn(9, 400, {0, 0, 0}, 40);
  const emtr::Rigid pose = emtr_test::motion({20, -30, 10}, {0.1, 0.2, 0});
  Points shrunk = source;
  for (auto& p : shrunk) p /= 40;
  std::vector<double> of_source(400), of_target(500), expected(400), others(500);
  emtr::residuals(view(source), view(target), {1.0 / 40, pose}, 1, of_source.data(),
                  of_target.data());
  emtr::residuals(view(shrunk), view(target), {1, pose}, 1, expected.data(), others.data());
  for (std::size_t i = 0; i < 400; ++i) EXPECT_NEAR(of_source[i], expected[i], 1e-6);
  for (std::size_t i = 0; i < 500; ++i) EXPECT_NEAR(of_target[i], others[i], 4e-6);
}

TEST(Residuals, AreTheSameForAnyThreads) {
  const Points target = drawn(3, 5000, {0, 0, 0}, 1), source = drawn(4, 200000, {0.1, 0, 0}, 1);
  std::vector<double> one(source.size()), more(source.size());
  emtr::residuals(view(source), view(target), {}, 1, one.data(), nullptr);
  for (const int threads : {2, 5}) {
    emtr::residuals(view(source), view(target), {}, threads, more.data(), nullptr);
    EXPECT_EQ(one, more) << threads;
  }
}

TEST(Residuals, OfPointsThatAreNotFiniteAreNaN) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Points source = drawn(5, 10, {0, 0, 0}, 1), target = {{nan, 0, 0}, {1, 2, 3}};
  source[4].y() = nan;
  source[7].z() = std::numeric_limits<double>::infinity();
  std::vector<double> of_source(10), of_target(2);
  emtr::residuals(view(source), view(target), {}, 1, of_source.data(), of_target.data());
  for (std::size_t i = 0; i < 10; ++i) {
    if (i == 4 || i == 7)
      EXPECT_TRUE(std::isnan(of_source[i]));
    else
      EXPECT_NEAR(of_source[i], (source[i] - target[1]).norm(), 1e-12);
  }
  EXPECT_TRUE(std::isnan(of_target[0]));
  EXPECT_GT(of_target[1], 0);
}

TEST(Residuals, OfAPointOnAPointAreZero) {
  const Points points = drawn(6, 3000, {1e6, 0, 0}, 1);
  std::vector<double> out(points.size(), 7);
  emtr::residuals(view(points), view(points), {}, 2, out.data(), nullptr);
  for (const double v : out) EXPECT_EQ(v, 0);
}

/// All points are then as near, but for rounding, and are not to be looked at one by one.
TEST(Residuals, OfCloudsFarApartAreTheDistancesToo) {
  const std::size_t n = 100000;
  const Points target = drawn(8, n, {0, 0, 0}, 1), source = drawn(9, n, {4e5, 3e5, 0}, 1);
  std::vector<double> out(n);
  emtr::residuals(view(source), view(target), {}, 2, out.data(), nullptr);
  for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(out[i], source[i].norm(), 2) << i;
}

TEST(Residuals, RefuseWhatHasNoAnswer) {
  const Points points = drawn(7, 10, {0, 0, 0}, 1), none, nowhere = {{NAN, 0, 0}},
               away = {{1e7, 0, 0}};
  std::vector<double> out(10);
  const auto status = [&](const Points& source, const Points& target) {
    try {
      emtr::residuals(view(source), view(target), {}, 1, out.data(), nullptr);
    } catch (const emtr::Error& error) {
      return error.status();
    }
    return EMTR_OK;
  };
  EXPECT_EQ(status(points, none), EMTR_ERROR_CLOUD);
  EXPECT_EQ(status(points, nowhere), EMTR_ERROR_CLOUD);
  EXPECT_EQ(status(none, points), EMTR_OK);
  EXPECT_EQ(status(away, points), EMTR_ERROR_ARGUMENT);
}

}  // namespace
