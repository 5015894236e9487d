#include <gtest/gtest.h>

#include "support/clouds.h"
#include "voxels/voxel_counter.h"
#include "voxels/voxel_grid.h"

namespace {

TEST(VoxelCounter, CountsWhatPclWouldReturn) {
  const emtr::Cloud cloud = emtr_test::uniform_cloud(5000, 3);
  emtr::VoxelCounter counter(cloud);
  for (const float leaf : {0.2f, 0.004f, 0.013f, 0.05f, 0.9f, 3.0f})
    EXPECT_EQ(counter(leaf), emtr::voxel_grid(cloud, leaf).size()) << leaf;
}

TEST(VoxelCounter, CountsPointsOnTheFacesOfVoxelsAsPclDoes) {
  emtr::Cloud cloud;
  for (int i = -40; i <= 40; ++i)
    for (int j = -4; j <= 4; ++j)
      emtr_test::push(cloud, static_cast<float>(i) * 0.025f, static_cast<float>(j) * 0.25f, -0.5f);
  emtr::VoxelCounter counter(cloud);
  for (const float leaf : {0.025f, 0.05f, 0.1f, 0.25f, 0.5f})
    EXPECT_EQ(counter(leaf), emtr::voxel_grid(cloud, leaf).size()) << leaf;
}

}  // namespace
