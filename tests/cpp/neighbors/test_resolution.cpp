#include <gtest/gtest.h>

#include <utility>

#include "neighbors/resolution.h"
#include "preprocessing/downsampling.h"
#include "preprocessing/normalization.h"
#include "settings/settings.h"
#include "support/clouds.h"

namespace {

TEST(Resolution, IsTheMeanDistanceToTheNearestOther) {
  emtr::Cloud cloud;
  for (const float x : {0.0f, 1.0f, 3.0f}) emtr_test::push(cloud, x, 0, 0);
  EXPECT_DOUBLE_EQ(emtr::mean_resolution(cloud), (1.0 + 1.0 + 2.0) / 3);
  EXPECT_DOUBLE_EQ(emtr::mean_resolution(cloud, 0.5, emtr::select_kernels(), 1),
                   (1.0 + 1.0 + 2.0) / 3);
}

TEST(Spacing, IsTheMeanDistanceToTheNearestOtherPlace) {
  emtr::Cloud cloud;
  for (const float x : {0.0f, 1.0f, 3.0f}) emtr_test::push(cloud, x, 0, 0);
  EXPECT_DOUBLE_EQ(emtr::mean_spacing(cloud, 1000), (1.0 + 1.0 + 2.0) / 3);
  for (int copy = 0; copy < 5; ++copy)
    for (const float x : {0.0f, 1.0f, 3.0f}) emtr_test::push(cloud, x, 0, 0);
  EXPECT_DOUBLE_EQ(emtr::mean_spacing(cloud, 1000), (1.0 + 1.0 + 2.0) / 3);
  EXPECT_DOUBLE_EQ(emtr::mean_spacing(cloud, 9), (1.0 + 1.0 + 2.0) / 3);  // every other
  emtr::Cloud one_place;
  for (int copy = 0; copy < 12; ++copy) emtr_test::push(one_place, 1, 2, 3);
  EXPECT_DOUBLE_EQ(emtr::mean_spacing(one_place, 1000), 0);
}

TEST(Resolution, IsTheSameBitsOnTheGridAndInTheTree) {
  const emtr_test::Pair pair(4);
  const emtr::DownsampledClouds d =
      emtr::downsample(emtr::normalize(pair.source(), pair.target(), 1), emtr::preset("paper"));
  emtr::Cloud twins = emtr_test::uniform_cloud(400, 2);
  for (std::size_t i = 0; i < 100; ++i) emtr_test::push(twins, twins.x[i], twins.y[i], twins.z[i]);
  emtr::Cloud far = emtr_test::uniform_cloud(300, 3, 0.01f);
  emtr_test::push(far, 90, -80, 70);  // its nearest is many cells away
  emtr_test::push(far, -95, 80, 70);
  for (const auto& [cloud, leaf] : {std::pair{d.source_dense, d.leaf_dense},
                                    {d.target_sparse, d.leaf_sparse},
                                    {d.target_dense, d.leaf_dense / 7},
                                    {d.target_dense, 30 * d.leaf_dense},
                                    {twins, 0.1},
                                    {far, 0.001}})
    for (const emtr::Kernels* kernels : emtr_test::kernels_here())
      for (const int threads : {1, 2, 3})
        EXPECT_EQ(emtr::mean_resolution(cloud, leaf, *kernels, threads),
                  emtr::mean_resolution(cloud))
            << kernels->name << " " << cloud.size() << " points, leaf " << leaf;
}

}  // namespace
