#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "voxels/voxel_index.h"

namespace {

TEST(VoxelIndex, IsTheFloorOnBothSidesOfZero) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> coordinate(-1.5f, 1.5f), leaf(2e-3f, 1);
  for (int i = 0; i < 10000; ++i) {
    const float v = coordinate(random), inverse = 1 / leaf(random);
    ASSERT_EQ(emtr::voxel_index(v, inverse), static_cast<int>(std::floor(v * inverse))) << v;
  }
}

TEST(VoxelIndex, ABorderBelongsToTheUpperVoxel) {
  for (int k = -5; k <= 5; ++k) {
    const float border = static_cast<float>(k) * 0.25f;
    EXPECT_EQ(emtr::voxel_index(border, 4), k);
    EXPECT_EQ(emtr::voxel_index(std::nextafter(border, -9.0f), 4), k - 1);
  }
}

}  // namespace
