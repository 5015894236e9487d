#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "neighbors/resolution.h"
#include "preprocessing/base_points.h"
#include "preprocessing/normalization.h"
#include "preprocessing/preprocessed_cloud.h"
#include "support/clouds.h"
#include "util/error.h"
#include "voxels/voxel_grid.h"

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
emtr::Cloud all_points(const std::vector<float>& packed,
                       const emtr::PreprocessedCloud& preprocessed) {
  emtr::Cloud cloud;
  const auto unit = [&](std::size_t i, int k) {
    return static_cast<float>(
        (double{packed[3 * i + static_cast<std::size_t>(k)]} - preprocessed.center[k]) *
        (1 / preprocessed.radius));
  };
  for (std::size_t i = 0; i < packed.size() / 3; ++i)
    if (std::isfinite(packed[3 * i + 2]))
      emtr_test::push(cloud, unit(i, 0), unit(i, 1), unit(i, 2));
  return cloud;
}

TEST(PreprocessedCloud, KeepsEveryPointOfASmallCloudInOrder) {
  const std::vector<float> packed = plate(70000);  // more than one block
  const emtr::PreprocessedCloud preprocessed(view(packed), "", 2);
  EXPECT_EQ(preprocessed.dropped, 722u);
  EXPECT_EQ(preprocessed.count, 70000u - 722u);
  const emtr::Cloud all = all_points(packed, preprocessed);
  EXPECT_EQ(preprocessed.base.x, all.x);
  EXPECT_EQ(preprocessed.base.y, all.y);
  EXPECT_EQ(preprocessed.base.z, all.z);
}

TEST(PreprocessedCloud, ThinsALargeCloudAsPclWouldAtOnce) {
  const std::vector<float> packed = plate(600000);
  const emtr::PreprocessedCloud preprocessed(view(packed), "", 2);
  EXPECT_EQ(preprocessed.count + preprocessed.dropped, 600000u);
  EXPECT_LT(preprocessed.base.size(), preprocessed.count / 2);
  const Rows slabs = sorted(preprocessed.base);
  const Rows whole = sorted(emtr::voxel_grid(all_points(packed, preprocessed), 0.004f));
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

TEST(PreprocessedCloud, HasTheSameBitsForAnyNumberOfThreads) {
  for (const std::size_t points : {150000u, 500000u}) {
    const std::vector<float> packed = plate(points);
    const emtr::PreprocessedCloud one(view(packed), "", 1);
    for (const int threads : {2, 3, 8}) {
      const emtr::PreprocessedCloud other(view(packed), "", threads);
      EXPECT_TRUE(std::equal(one.center, one.center + 3, other.center));
      EXPECT_EQ(one.radius, other.radius);
      EXPECT_EQ(one.base.x, other.base.x);
      EXPECT_EQ(one.base.y, other.base.y);
      EXPECT_EQ(one.base.z, other.base.z);
    }
  }
}

TEST(PreprocessedCloud, StaysSmallWhateverIsInIt) {
  const emtr::Cloud box = emtr_test::uniform_cloud(1500000, 7);
  std::vector<float> packed;
  for (std::size_t i = 0; i < box.size(); ++i)
    packed.insert(packed.end(), {box.x[i], box.y[i], box.z[i]});
  const emtr::PreprocessedCloud preprocessed(view(packed), "", 2);
  EXPECT_EQ(preprocessed.count, box.size());
  EXPECT_LE(preprocessed.base.size(), 1u << 20);
  EXPECT_GT(preprocessed.base.size(), 100000u);
}

TEST(PreprocessedCloud, LeavesTheLargerOfAPairAsItIs) {
  const emtr_test::Pair small(3, 1000, 1), large(4, 1200, 7);
  const auto source = std::make_shared<emtr::PreprocessedCloud>(small.source(), "source", 1);
  const auto target = std::make_shared<emtr::PreprocessedCloud>(large.target(), "target", 1);
  const emtr::NormalizedPair pair = emtr::normalize(source, target);
  EXPECT_EQ(pair.normalization.scale, target->radius);
  EXPECT_EQ(pair.target.x, target->base.x);
  const double factor = source->radius / target->radius;
  EXPECT_LT(factor, 0.3);
  for (std::size_t i = 0; i < pair.source.size(); ++i)
    EXPECT_FLOAT_EQ(pair.source.z[i], static_cast<float>(factor * source->base.z[i]));
}

TEST(PreprocessedCloud, KnowsItsSpacing) {
  const emtr_test::Pair pair(3, 9000);
  const emtr::PreprocessedCloud preprocessed(pair.source(), "", 1);
  EXPECT_NEAR(preprocessed.spacing() / emtr::mean_resolution(preprocessed.base), 1, 0.03);
}

TEST(PreprocessedCloud, NamesItselfInErrors) {
  const std::vector<float> packed(27, 1.0f);
  const auto message = [&](const char* name) -> std::string {
    try {
      emtr::PreprocessedCloud(view(packed), name, 1);
    } catch (const emtr::Error& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_EQ(message("scan 7").rfind("scan 7 cloud: 9 finite points of 9", 0), 0u);
  EXPECT_EQ(message("").rfind("cloud: 9 finite points of 9", 0), 0u);
}

}  // namespace
