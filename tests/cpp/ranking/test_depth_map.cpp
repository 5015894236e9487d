#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "geometry/euler.h"
#include "ranking/depth_map.h"
#include "ranking/surfaces.h"

namespace {

using emtr::Cloud;
using emtr::DepthMap;
using emtr::DirectionBins;
using emtr::Rigid;
using emtr_test::Vector;

constexpr double kOrigin[3] = {0, 0, 0};

/// z = 2, from -1 to 1 each way, with a round hole about (0.5, 0.5).
Cloud wall(double leaf, double hole = 0) {
  Cloud out;
  const int half = static_cast<int>(1 / leaf);
  for (int i = -half; i <= half; ++i)
    for (int j = -half; j <= half; ++j) {
      const double x = leaf * i, y = leaf * j;
      if (std::hypot(x - 0.5, y - 0.5) < hole) continue;
      emtr_test::push(out, static_cast<float>(x), static_cast<float>(y), 2);
    }
  return out;
}

std::size_t in_front(const DepthMap& map, const Vector& p, const Rigid& pose = {}) {
  Cloud one;
  emtr_test::push(one, static_cast<float>(p[0]), static_cast<float>(p[1]),
                  static_cast<float>(p[2]));
  DepthMap::Scratch scratch;
  return map.in_front(one, pose, scratch);
}

TEST(DepthMap, InFrontOfAWallAndNotBehindNorBesideIt) {
  const DepthMap map(wall(0.04), kOrigin, 0.04, emtr::select_kernels());
  EXPECT_EQ(in_front(map, {0.1, -0.2, 1}), 1u);
  EXPECT_EQ(in_front(map, {0.1, -0.2, 1.85}), 1u);
  EXPECT_EQ(in_front(map, {0.1, -0.2, 1.95}), 1u);
  EXPECT_EQ(in_front(map, {0.1, -0.2, 1.98}), 0u);  // not clearly
  EXPECT_EQ(in_front(map, {0.1, -0.2, 2}), 0u);
  EXPECT_EQ(in_front(map, {0.1, -0.2, 3}), 0u);
  EXPECT_EQ(in_front(map, {1.5, 0, 1}), 0u);    // out of view
  EXPECT_EQ(in_front(map, {0.1, 0, -1}), 0u);   // behind the sensor
  EXPECT_EQ(in_front(map, {0, 0, 0.001}), 1u);  // the sensor itself stood in empty space
}

TEST(DepthMap, LeavesOutMarkedPoints) {
  const DepthMap map(wall(0.04), kOrigin, 0.04, emtr::select_kernels());
  Cloud two;
  emtr_test::push(two, 0.1f, -0.2f, 1);
  emtr_test::push(two, 0.2f, 0.1f, 1);
  DepthMap::Scratch scratch;
  const std::uint8_t one_marked[] = {0, 1}, both_marked[] = {1, 1};
  EXPECT_EQ(map.in_front(two, Rigid{}, scratch), 2u);
  EXPECT_EQ(map.in_front(two, Rigid{}, scratch, one_marked), 1u);
  EXPECT_EQ(map.in_front(two, Rigid{}, scratch, both_marked), 0u);
}

TEST(DepthMap, KnowsNothingOfAHole) {
  const DepthMap map(wall(0.04, 0.3), kOrigin, 0.04, emtr::select_kernels());
  EXPECT_EQ(in_front(map, {0.25, 0.25, 1}), 0u);
  EXPECT_EQ(in_front(map, {-0.25, 0.25, 1}), 1u);
}

TEST(DepthMap, NeedsMostOfTheBinsAboutIt) {
  // Every third column of the wall only: 3 of 9 bins, and one that is alone.
  Cloud sparse;
  const Cloud full = wall(0.04);
  for (std::size_t i = 0; i < full.size(); ++i)
    if (std::lround(full.x[i] / 0.04f) % 3 == 0) emtr_test::push(sparse, full.x[i], full.y[i], 2);
  const DepthMap map(sparse, kOrigin, 0.04, emtr::select_kernels());
  EXPECT_EQ(in_front(map, {0.1, -0.2, 1}), 0u);
}

TEST(DepthMap, TheNearestOfTheNeighborsCounts) {
  Cloud cloud = wall(0.04);  // a post stands before the wall
  for (int j = -25; j <= 25; ++j) emtr_test::push(cloud, 0, 0.02f * static_cast<float>(j), 1);
  const DepthMap map(cloud, kOrigin, 0.04, emtr::select_kernels());
  EXPECT_EQ(in_front(map, {0, 0.1, 1.5}), 0u);     // behind the post
  EXPECT_EQ(in_front(map, {0.03, 0.1, 1.5}), 0u);  // just beside: in one of its neighbors' bins
  EXPECT_EQ(in_front(map, {0.2, 0.1, 1.5}), 1u);
}

TEST(DepthMap, ThePoseMovesThePoints) {
  const DepthMap map(wall(0.04), kOrigin, 0.04, emtr::select_kernels());
  const double particle[6] = {0, 1.5707963267948966, 0, 0, 0, 0.1};  // x to -z
  EXPECT_EQ(in_front(map, {-1, 0.1, 0.05}, emtr::decode(particle)), 1u);
  EXPECT_EQ(in_front(map, {-2.1, 0.1, 0.05}, emtr::decode(particle)), 0u);
}

TEST(DepthMap, SeesAllAround) {
  const emtr::Surface ball = emtr_test::lumpy_ball(30000, 1, 0.04);
  const double inside[3] = {0.05, -0.02, 0.03};
  const DepthMap map(ball.points, inside, 0.04, emtr::select_kernels());
  DepthMap::Scratch scratch;
  for (const double scale : {0.5, 1.2}) {
    Cloud shell;
    for (std::size_t i = 0; i < ball.points.size(); ++i)
      emtr_test::push(shell, static_cast<float>(scale) * ball.points.x[i],
                      static_cast<float>(scale) * ball.points.y[i],
                      static_cast<float>(scale) * ball.points.z[i]);
    const double share = static_cast<double>(map.in_front(shell, Rigid{}, scratch)) / 30000;
    if (scale < 1)
      EXPECT_GT(share, 0.95);  // but for a few bins at the edges of the cube
    else
      EXPECT_EQ(share, 0);
  }
}

TEST(DepthMap, SameCountForEveryKernel) {
  const emtr::Surface a = emtr_test::lumpy_ball(2001, 2, 0.05),
                      b = emtr_test::lumpy_ball(999, 3, 1);
  const double viewpoint[3] = {0, 0, 0.1}, particle[6] = {1, 0.3, 2, 0.2, 0, 0.1};
  std::set<std::size_t> counts;
  for (const emtr::Kernels* kernels : emtr_test::kernels_here()) {
    DepthMap::Scratch scratch;
    counts.insert(DepthMap(a.points, viewpoint, 0.05, *kernels)
                      .in_front(b.points, emtr::decode(particle), scratch));
  }
  EXPECT_EQ(counts.size(), 1u);
  EXPECT_GT(*counts.begin(), 20u);
}

TEST(DirectionBins, AreOfNearlyOneSize) {
  const double viewpoint[3] = {0.3, -0.2, 0.9}, facing[3] = {-0.4, 0.1, 0};
  const DirectionBins bins(viewpoint, facing, 0.05);
  const auto there = emtr_test::carry(bins.to_view(), {facing[0], facing[1], facing[2]});
  EXPECT_NEAR(there[0], 0, 1e-12);
  EXPECT_NEAR(there[1], 0, 1e-12);
  EXPECT_GT(there[2], 0.9);
  const auto ahead = bins(0.001f, 0.001f, 1);
  EXPECT_EQ(std::make_tuple(ahead.face, ahead.column, ahead.row),
            std::make_tuple(0, bins.side() / 2, bins.side() / 2));

  std::vector<int> hits(static_cast<std::size_t>(6 * bins.side() * bins.side()), 0);
  const emtr::Surface ball = emtr_test::lumpy_ball(200000, 4, 1);
  for (std::size_t i = 0; i < ball.points.size(); ++i) {
    const auto bin = bins(ball.points.x[i], ball.points.y[i], ball.points.z[i]);
    ASSERT_TRUE(bin.face >= 0 && bin.face < 6 && bin.column >= 0 && bin.row >= 0 &&
                bin.column < bins.side() && bin.row < bins.side());
    ++hits[static_cast<std::size_t>((bin.face * bins.side() + bin.row) * bins.side() + bin.column)];
  }
  std::sort(hits.begin(), hits.end());
  const auto at = [&](double q) {
    return hits[static_cast<std::size_t>(q * static_cast<double>(hits.size()))];
  };
  EXPECT_GT(at(0.05), 0.5 * at(0.5));
  EXPECT_LT(at(0.95), 1.9 * at(0.5));
}

}  // namespace
