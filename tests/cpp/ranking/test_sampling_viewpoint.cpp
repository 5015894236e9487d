#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <set>

#include "geometry/euler.h"
#include "ranking/sampling_viewpoint.h"
#include "ranking/surfaces.h"
#include "support/lidar_street.h"

namespace {

using emtr::estimate_sampling_viewpoint;
using emtr::Surface;
using emtr::Viewpoint;
using emtr_test::Vector;

constexpr double kLeaf = 0.05;
constexpr double kFarOrigin[3] = {50, 50, 50};

struct Scan {
  emtr::Cloud cloud;
  Surface surface;
};

/// A room of 2 x 1.4 x 1, as a scanner at `from` samples it: evenly over directions.
Scan scan_room(const Vector& from, int rays = 40000) {
  const double half[3] = {1, 0.7, 0.5};
  std::mt19937 random(7);
  const auto draw = [&] { return static_cast<double>(random()) / 2147483648.0 - 1; };
  Scan out;
  out.surface.leaf = kLeaf;
  std::set<std::array<int, 3>> taken;
  for (int i = 0; i < rays;) {
    Vector u{draw(), draw(), draw()};
    const double length = std::sqrt(emtr_test::dot(u, u));
    if (length > 1 || length < 0.1) continue;
    ++i;
    double range = HUGE_VAL;
    std::size_t axis = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      const double r = ((u[a] > 0 ? half[a] : -half[a]) - from[a]) / (u[a] / length);
      if (r < range) range = r, axis = a;
    }
    Vector p, n{};
    std::array<int, 3> cell{};
    for (std::size_t a = 0; a < 3; ++a) {
      p[a] = from[a] + range * u[a] / length;
      cell[a] = static_cast<int>(std::floor(p[a] / kLeaf));
    }
    n[axis] = 1;
    emtr_test::push(out.cloud, static_cast<float>(p[0]), static_cast<float>(p[1]),
                    static_cast<float>(p[2]));
    if (taken.insert(cell).second) emtr_test::push(out.surface, p, n);
  }
  return out;
}

double distance(const Viewpoint& v, const Vector& from) {
  return std::sqrt(std::pow(v.at[0] - from[0], 2) + std::pow(v.at[1] - from[1], 2) +
                   std::pow(v.at[2] - from[2], 2));
}

TEST(SamplingViewpoint, IsWhereTheScannerStood) {
  for (const Vector& from : {Vector{0, 0, 0}, Vector{0.4, -0.2, 0.1}, Vector{-0.7, 0.3, -0.2}}) {
    const Scan scan = scan_room(from);
    const Viewpoint found =
        estimate_sampling_viewpoint(scan.surface, scan.cloud, kFarOrigin, emtr::select_kernels());
    EXPECT_LT(distance(found, from), 0.06) << from[0];
    EXPECT_EQ(found.trust, 1);
    EXPECT_FALSE(found.given);
  }
}

TEST(SamplingViewpoint, IsTheOriginWhereThatDoesAsWell) {
  const Vector from{0.4, -0.2, 0.1};
  const Scan scan = scan_room(from);
  const double near[3] = {0.41, -0.2, 0.1};
  const Viewpoint found =
      estimate_sampling_viewpoint(scan.surface, scan.cloud, near, emtr::select_kernels());
  for (std::size_t a = 0; a < 3; ++a) EXPECT_EQ(found.at[a], near[a]);
}

/// The points, and one of them in each voxel.
Scan scan_street() {
  const emtr_test::StreetScan street = emtr_test::scan_street(900);
  Scan out;
  out.cloud = street.points;
  out.surface.leaf = 0.01;
  std::set<std::array<int, 3>> taken;
  for (std::size_t i = 0; i < street.points.size(); ++i) {
    const Vector p = emtr_test::point(street.points, i);
    std::array<int, 3> cell{};
    for (std::size_t a = 0; a < 3; ++a)
      cell[a] = static_cast<int>(std::floor(p[a] / out.surface.leaf));
    if (taken.insert(cell).second)
      emtr_test::push(out.surface, p, emtr_test::point(street.normals, i));
  }
  return out;
}

TEST(SamplingViewpoint, IsTheOriginOfAScannerWithFewRings) {
  const Scan scan = scan_street();
  const auto estimate = [&](const Vector& origin) {
    return estimate_sampling_viewpoint(scan.surface, scan.cloud, origin.data(),
                                       emtr::select_kernels());
  };
  const Viewpoint free = estimate({50, 50, 50}), found = estimate({0, 0, 0});
  EXPECT_GT(distance(free, {0, 0, 0}), 0.02);  // the rings pull it away
  EXPECT_EQ(distance(found, {0, 0, 0}), 0);
  const Vector elsewhere{0.3, 0.3, 0.3};
  EXPECT_GT(distance(estimate(elsewhere), elsewhere), 0.1);
}

TEST(SamplingViewpoint, IsNotBelievedOfAnEvenlySampledCloud) {
  Scan even;  // four walls, with as many points everywhere
  even.surface.leaf = kLeaf;
  std::mt19937 random(8);
  const auto draw = [&] { return static_cast<double>(random()) / 2147483648.0 - 1; };
  std::set<std::array<int, 3>> taken;
  for (int i = 0; i < 40000; ++i) {
    const bool across = i % 2 == 0;
    const double along = draw(), height = 0.5 * draw(), side = i % 4 < 2 ? -0.99 : 0.99;
    const Vector p = across ? Vector{side, along, height} : Vector{along, side, height};
    std::array<int, 3> cell{};
    for (std::size_t a = 0; a < 3; ++a) cell[a] = static_cast<int>(std::floor(p[a] / kLeaf));
    emtr_test::push(even.cloud, static_cast<float>(p[0]), static_cast<float>(p[1]),
                    static_cast<float>(p[2]));
    if (taken.insert(cell).second)
      emtr_test::push(even.surface, p, across ? Vector{1, 0, 0} : Vector{0, 1, 0});
  }
  EXPECT_LT(
      estimate_sampling_viewpoint(even.surface, even.cloud, kFarOrigin, emtr::select_kernels())
          .trust,
      0.5);
}

TEST(SamplingViewpoint, HasNoTrustWhereNothingVaries) {
  Surface one;  // a point a voxel
  one.leaf = 0.1;
  for (int i = 0; i < 100; ++i) emtr_test::push(one, {0.1 * i + 0.05, 0.05, 0.05}, {0, 0, 1});
  EXPECT_EQ(estimate_sampling_viewpoint(one, one.points, kFarOrigin, emtr::select_kernels()).trust,
            0);
  Surface bare = one;  // without a normal
  for (auto* v : {&bare.normals.x, &bare.normals.y, &bare.normals.z}) v->assign(100, NAN);
  EXPECT_EQ(
      estimate_sampling_viewpoint(bare, bare.points, kFarOrigin, emtr::select_kernels()).trust, 0);
}

}  // namespace
