#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "error.h"
#include "features/resolution.h"
#include "features/voxel_grid.h"
#include "frame/base_points.h"
#include "frame/frame.h"
#include "frame/prepared_cloud.h"
#include "support/clouds.h"

namespace {

using Rows = std::vector<std::array<float, 3>>;

emtr_cloud view(const std::vector<float>& packed) {
  return {packed.data(), packed.size() / 3, 0, EMTR_FLOAT32};
}

/// A wavy plate, long in y, far from the origin, every 97th point of it missing.
std::vector<float> plate(std::size_t points) {
  const emtr::Cloud flat = emtr_test::uniform_cloud(points, 5);
  std::vector<float> packed;
  for (std::size_t i = 0; i < points; ++i) {
    const float x = flat.x[i], y = flat.y[i];
    const float z =
        i % 97 ? 0.2f * std::sin(5 * x + 3 * y) : std::numeric_limits<float>::infinity();
    packed.insert(packed.end(), {300 + 20 * x, 700 + 30 * y, -90 + 20 * z});
  }
  return packed;
}

Rows sorted(const emtr::Cloud& cloud) {
  Rows rows;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    rows.push_back({cloud.x[i], cloud.y[i], cloud.z[i]});
  std::sort(rows.begin(), rows.end());
  return rows;
}

/// All finite points by (p - center) * (1 / radius), one by one.
emtr::Cloud all_points(const std::vector<float>& packed, const emtr::PreparedCloud& prepared) {
  emtr::Cloud cloud;
  const auto unit = [&](std::size_t i, int k) {
    return static_cast<float>(
        (double{packed[3 * i + static_cast<std::size_t>(k)]} - prepared.center[k]) *
        (1 / prepared.radius));
  };
  for (std::size_t i = 0; i < packed.size() / 3; ++i)
    if (std::isfinite(packed[3 * i + 2]))
      emtr_test::push(cloud, unit(i, 0), unit(i, 1), unit(i, 2));
  return cloud;
}

TEST(PreparedCloud, KeepsEveryPointOfASmallCloudInOrder) {
  const std::vector<float> packed = plate(70000);  // more than one block
  const emtr::PreparedCloud prepared(view(packed), "", 2);
  EXPECT_EQ(prepared.dropped, 722u);
  EXPECT_EQ(prepared.count, 70000u - 722u);
  const emtr::Cloud all = all_points(packed, prepared);
  EXPECT_EQ(prepared.base.x, all.x);
  EXPECT_EQ(prepared.base.y, all.y);
  EXPECT_EQ(prepared.base.z, all.z);
}

TEST(PreparedCloud, ThinsALargeCloudAsPclWouldAtOnce) {
  const std::vector<float> packed = plate(600000);
  const emtr::PreparedCloud prepared(view(packed), "", 2);
  EXPECT_EQ(prepared.count + prepared.dropped, 600000u);
  EXPECT_LT(prepared.base.size(), prepared.count / 2);
  const Rows slabs = sorted(prepared.base);
  const Rows whole = sorted(emtr::voxel_grid(all_points(packed, prepared), 0.004f));
  ASSERT_EQ(slabs.size(), whole.size());
  // PCL adds the points of a voxel in an order of its own, so the last digits may differ, and
  // with them the order of rows: each is near one of the other's.
  std::size_t near = 0;
  for (std::size_t i = 0; i < slabs.size(); ++i)
    near += std::abs(slabs[i][0] - whole[i][0]) < 1e-6f &&
            std::abs(slabs[i][1] - whole[i][1]) < 1e-6f &&
            std::abs(slabs[i][2] - whole[i][2]) < 1e-6f;
  EXPECT_GT(near, slabs.size() * 99 / 100);
}

TEST(PreparedCloud, HasTheSameBitsForAnyNumberOfThreads) {
  for (const std::size_t points : {150000u, 500000u}) {
    const std::vector<float> packed = plate(points);
    const emtr::PreparedCloud one(view(packed), "", 1);
    for (const int threads : {2, 3, 8}) {
      const emtr::PreparedCloud other(view(packed), "", threads);
      EXPECT_TRUE(std::equal(one.center, one.center + 3, other.center));
      EXPECT_EQ(one.radius, other.radius);
      EXPECT_EQ(one.base.x, other.base.x);
      EXPECT_EQ(one.base.y, other.base.y);
      EXPECT_EQ(one.base.z, other.base.z);
    }
  }
}

TEST(PreparedCloud, StaysSmallWhateverIsInIt) {
  const emtr::Cloud box = emtr_test::uniform_cloud(1500000, 7);
  std::vector<float> packed;
  for (std::size_t i = 0; i < box.size(); ++i)
    packed.insert(packed.end(), {box.x[i], box.y[i], box.z[i]});
  const emtr::PreparedCloud prepared(view(packed), "", 2);
  EXPECT_EQ(prepared.count, box.size());
  EXPECT_LE(prepared.base.size(), 1u << 20);
  EXPECT_GT(prepared.base.size(), 100000u);
}

TEST(PreparedCloud, LeavesTheLargerOfAPairAsItIs) {
  const emtr_test::Pair small(3, 1000, 1), large(4, 1200, 7);
  const auto source = std::make_shared<emtr::PreparedCloud>(small.source(), "source", 1);
  const auto target = std::make_shared<emtr::PreparedCloud>(large.target(), "target", 1);
  const emtr::NormalisedPair pair = emtr::normalise(source, target);
  EXPECT_EQ(pair.frame.scale, target->radius);
  EXPECT_EQ(pair.target.x, target->base.x);
  const double factor = source->radius / target->radius;
  EXPECT_LT(factor, 0.3);
  for (std::size_t i = 0; i < pair.source.size(); ++i)
    EXPECT_FLOAT_EQ(pair.source.z[i], static_cast<float>(factor * source->base.z[i]));
}

TEST(PreparedCloud, KnowsItsSpacing) {
  const emtr_test::Pair pair(3, 9000);
  const emtr::PreparedCloud prepared(pair.source(), "", 1);
  EXPECT_NEAR(prepared.spacing() / emtr::mean_resolution(prepared.base), 1, 0.03);
}

TEST(PreparedCloud, NamesItselfInErrors) {
  const std::vector<float> packed(27, 1.0f);
  const auto message = [&](const char* name) -> std::string {
    try {
      emtr::PreparedCloud(view(packed), name, 1);
    } catch (const emtr::Error& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_EQ(message("scan 7").rfind("scan 7 cloud: 9 finite points of 9", 0), 0u);
  EXPECT_EQ(message("").rfind("cloud: 9 finite points of 9", 0), 0u);
}

}  // namespace
