#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "ranking/surfaces.h"
#include "ranking/visible_viewpoint.h"

namespace {

using emtr::estimate_visible_viewpoint;
using emtr::Surface;
using emtr::Viewpoint;
using emtr_test::lumpy_ball;
using emtr_test::point;
using emtr_test::Vector;

const emtr::Kernels& kernels() { return emtr::select_kernels(); }

constexpr double kLeaf = 0.04;

/// The lumpy ball with the points as far apart as a voxel grid leaves them; only those that `take`
/// says.
template <class Take>
Surface thinned(unsigned seed, Take take) {
  const Surface all = lumpy_ball(20000, seed, kLeaf);
  Surface out;
  out.leaf = kLeaf;
  std::set<std::array<int, 3>> taken;
  for (std::size_t i = 0; i < all.points.size(); ++i) {
    const Vector p = point(all.points, i), n = point(all.normals, i);
    std::array<int, 3> cell;
    for (std::size_t a = 0; a < 3; ++a) cell[a] = static_cast<int>(std::floor(p[a] / kLeaf));
    if (take(p, n) && taken.insert(cell).second) emtr_test::push(out, p, n);
  }
  return out;
}

/// What a sensor at `from` sees of it.
Surface scan(const Vector& from, unsigned seed = 1) {
  return thinned(seed, [&](const Vector& p, const Vector& n) {
    const Vector d{from[0] - p[0], from[1] - p[1], from[2] - p[2]};
    return emtr_test::dot(n, d) > 0.1 * std::sqrt(emtr_test::dot(d, d));
  });
}

Vector from_centroid(const emtr::Cloud& points, const Vector& v) {
  Vector c{};
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t a = 0; a < 3; ++a)
      c[a] += point(points, i)[a] / static_cast<double>(points.size());
  return {v[0] - c[0], v[1] - c[1], v[2] - c[2]};
}

Vector place(const Viewpoint& v) { return {v.at[0], v.at[1], v.at[2]}; }

double degrees(const Vector& a, const Vector& b) {
  return std::acos(emtr_test::dot(a, b) / std::sqrt(emtr_test::dot(a, a) * emtr_test::dot(b, b))) *
         57.29577951308232;
}

TEST(VisibleViewpoint, OfAOneSidedScanIsFound) {
  double sum = 0;
  for (const Vector& from : {Vector{0, 0, 4}, Vector{3, 1, -2}, Vector{-1, 2.5, 1},
                             Vector{-6, -6, 2}, Vector{0.5, -3, 0}}) {
    const Surface seen = scan(from);
    const auto found = estimate_visible_viewpoint(seen, kernels());
    ASSERT_TRUE(found);
    EXPECT_FALSE(found->given);
    EXPECT_EQ(found->trust, 0);  // it may as well be the mirrored place
    const double off =
        degrees(from_centroid(seen.points, from), from_centroid(seen.points, place(*found)));
    sum += std::min(off, 180 - off);
    EXPECT_LT(std::min(off, 180 - off), 30) << from[0] << ' ' << from[1] << ' ' << from[2];
  }
  EXPECT_LT(sum / 5, 18);  // a half of a ball looks much the same from places far apart
}

TEST(VisibleViewpoint, AClosedModelHasNone) {
  const Surface all = thinned(2, [](const Vector&, const Vector&) { return true; });
  EXPECT_FALSE(estimate_visible_viewpoint(all, kernels()));
}

TEST(VisibleViewpoint, OrientsNormalsToItsSide) {
  const Vector from{1, 3, -1};
  Surface seen = scan(from);
  const Surface truth = seen;  // its normals look outwards, so to the sensor
  for (std::size_t i = 0; i < seen.points.size(); i += 2) {
    seen.normals.x[i] = -seen.normals.x[i];
    seen.normals.y[i] = -seen.normals.y[i];
    seen.normals.z[i] = -seen.normals.z[i];
  }
  emtr::orient_normals(seen.points, {1, 3, -1}, seen.normals);
  EXPECT_EQ(seen.normals.x, truth.normals.x);
  EXPECT_EQ(seen.normals.z, truth.normals.z);
  emtr::orient_normals(seen.points, {-30, -90, 30}, seen.normals);
  std::size_t flipped = 0;
  for (std::size_t i = 0; i < seen.points.size(); ++i)
    flipped += seen.normals.x[i] == -truth.normals.x[i];
  EXPECT_GT(flipped, seen.points.size() * 9 / 10);
}

TEST(VisibleViewpoint, SameForEveryKernel) {
  const Surface seen = scan({-1, 2.5, 1}, 3);
  const auto first = estimate_visible_viewpoint(seen, *emtr::kernels_at(0));
  ASSERT_TRUE(first);
  for (const emtr::Kernels* k : emtr_test::kernels_here())
    EXPECT_EQ(place(*estimate_visible_viewpoint(seen, *k)), place(*first));
}

TEST(VisibleViewpoint, FewPointsAreEnoughForAnAnswer) {
  for (const std::size_t n : {1u, 10u}) {
    const auto found = estimate_visible_viewpoint(lumpy_ball(n, 1, 0.1), kernels());
    if (!found) continue;
    for (const double at : found->at) EXPECT_TRUE(std::isfinite(at));
  }
}

}  // namespace
