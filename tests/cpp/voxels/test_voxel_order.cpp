#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <utility>

#include "support/clouds.h"
#include "util/constants.h"
#include "voxels/voxel_grid.h"
#include "voxels/voxel_order.h"

namespace {

using emtr::Cloud;
using emtr::kNone;

std::array<int, 3> voxel_of(const Cloud& cloud, std::size_t i, float leaf) {
  const float inverse = 1.0f / leaf;
  return {static_cast<int>(std::floor(cloud.z[i] * inverse)),
          static_cast<int>(std::floor(cloud.y[i] * inverse)),
          static_cast<int>(std::floor(cloud.x[i] * inverse))};
}

TEST(VoxelOrder, IsTheOrderOfTheVoxelGrid) {
  const Cloud cloud = emtr_test::uniform_cloud(3000, 1);
  for (const float leaf : {0.05f, 0.2f, 0.7f}) {
    // The position as the direction: a mean of normals then tells which points it was made of.
    const Cloud downsampled = emtr::voxel_grid(cloud, leaf);
    Cloud normals = cloud;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const auto voxel = voxel_of(cloud, i, leaf);
      const double x = voxel[2] + 0.25, y = voxel[1] + 0.25, z = voxel[0] + 0.25,
                   length = std::sqrt(x * x + y * y + z * z);
      const float n[3] = {static_cast<float>(x / length), static_cast<float>(y / length),
                          static_cast<float>(z / length)};
      normals.set(i, n);
    }
    const Cloud means = emtr::mean_normals(cloud, normals, leaf);
    ASSERT_EQ(means.size(), downsampled.size()) << leaf;
    for (std::size_t i = 0; i < means.size(); ++i) {
      const auto voxel = voxel_of(downsampled, i, leaf);
      const double x = voxel[2] + 0.25, y = voxel[1] + 0.25, z = voxel[0] + 0.25,
                   length = std::sqrt(x * x + y * y + z * z);
      EXPECT_NEAR(means.x[i], x / length, 1e-6);
      EXPECT_NEAR(means.y[i], y / length, 1e-6);
      EXPECT_NEAR(means.z[i], z / length, 1e-6);
    }
  }
}

TEST(VoxelOrder, MeansOfNormalsAreOfUnitLengthAndLeaveOutWhatIsNone) {
  Cloud cloud, normals;
  const auto add = [&](float x, float nx, float ny, float nz) {
    emtr_test::push(cloud, x, 0.05f, 0.05f);
    emtr_test::push(normals, nx, ny, nz);
  };
  add(0.01f, 1, 0, 0);
  add(0.02f, kNone, kNone, kNone);
  add(0.03f, 0, 1, 0);
  add(0.11f, kNone, kNone, kNone);
  add(0.21f, 0, 0, 1);
  add(0.22f, 0, 0, -1);
  const Cloud means = emtr::mean_normals(cloud, normals, 0.1f);
  ASSERT_EQ(means.size(), 3u);
  EXPECT_FLOAT_EQ(means.x[0], std::sqrt(0.5f));
  EXPECT_FLOAT_EQ(means.y[0], std::sqrt(0.5f));
  EXPECT_EQ(means.z[0], 0);
  EXPECT_TRUE(std::isnan(means.x[1]));  // the only one has none
  EXPECT_TRUE(std::isnan(means.z[2]));  // they cancel out
}

TEST(VoxelOrder, OneRowOfEachIsTheNearestToTheCenter) {
  const Cloud cloud = emtr_test::uniform_cloud(2000, 2);
  const float leaf = 0.3f;
  std::map<std::array<int, 3>, std::pair<double, std::uint32_t>> nearest;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const auto voxel = voxel_of(cloud, i, leaf);
    const double off[3] = {cloud.z[i] - (voxel[0] + 0.5) * double{leaf},
                           cloud.y[i] - (voxel[1] + 0.5) * double{leaf},
                           cloud.x[i] - (voxel[2] + 0.5) * double{leaf}};
    const std::pair found{off[0] * off[0] + off[1] * off[1] + off[2] * off[2],
                          static_cast<std::uint32_t>(i)};
    const auto [at, fresh] = nearest.emplace(voxel, found);
    if (!fresh) at->second = std::min(at->second, found);
  }
  std::vector<std::uint32_t> expected;
  for (const auto& [voxel, found] : nearest) expected.push_back(found.second);
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(emtr::one_row_per_voxel(cloud, leaf), expected);
  EXPECT_LT(expected.size(), 600u);
}

TEST(VoxelOrder, OneRowOfEachDoesNotDependOnTheOrder) {
  const Cloud cloud = emtr_test::uniform_cloud(2000, 3);
  std::vector<std::uint32_t> order(cloud.size());
  std::iota(order.begin(), order.end(), 0u);
  std::shuffle(order.begin(), order.end(), std::mt19937(4));
  std::vector<std::uint32_t> found;
  for (const std::uint32_t row : emtr::one_row_per_voxel(cloud.select(order), 0.2f))
    found.push_back(order[row]);
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, emtr::one_row_per_voxel(cloud, 0.2f));
}

TEST(VoxelOrder, MeanColorsAreThoseOfTheVoxelsPoints) {
  Cloud cloud, colors;
  for (const float x : {0.01f, 0.02f, 0.03f, 0.51f, 0.52f}) emtr_test::push(cloud, x, 0.01f, 0.01f);
  for (const float c : {0.1f, 0.3f, emtr::kNone, emtr::kNone, emtr::kNone})
    emtr_test::push(colors, c, 2 * c, 0);
  const Cloud mean = emtr::mean_colors(cloud, colors, 0.5f);
  ASSERT_EQ(mean.size(), 2u);
  EXPECT_FLOAT_EQ(mean.x[0], 0.2f);
  EXPECT_FLOAT_EQ(mean.y[0], 0.4f);
  EXPECT_TRUE(std::isnan(mean.x[1]));
}

TEST(VoxelOrder, IsEmptyWithoutPoints) {
  EXPECT_TRUE(emtr::one_row_per_voxel(Cloud(), 0.1f).empty());
  EXPECT_EQ(emtr::mean_normals(Cloud(), Cloud(), 0.1f).size(), 0u);
}

}  // namespace
