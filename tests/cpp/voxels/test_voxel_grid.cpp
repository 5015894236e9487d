#include <gtest/gtest.h>

#include <algorithm>

#include "support/clouds.h"
#include "voxels/voxel_grid.h"

namespace {

TEST(VoxelGrid, PutsTheCentroidInEachCube) {
  emtr::Cloud cloud;
  emtr_test::push(cloud, 0.1f, 0.1f, 0.1f);
  emtr_test::push(cloud, 0.3f, 0.1f, 0.1f);
  emtr_test::push(cloud, -0.5f, 0.1f, 0.1f);
  const emtr::Cloud out = emtr::voxel_grid(cloud, 1.0f);
  ASSERT_EQ(out.size(), 2u);
  EXPECT_FLOAT_EQ(std::max(out.x[0], out.x[1]), 0.2f);
  EXPECT_FLOAT_EQ(std::min(out.x[0], out.x[1]), -0.5f);
}

}  // namespace
