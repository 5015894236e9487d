#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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

double spacing_by_brute_force(const emtr::Cloud& cloud, std::size_t step) {
  double sum = 0;
  std::size_t queries = 0;
  for (std::size_t i = 0; i < cloud.size(); i += step, ++queries) {
    float least = HUGE_VALF;
    for (std::size_t j = 0; j < cloud.size(); ++j) {
      const float dx = cloud.x[i] - cloud.x[j], dy = cloud.y[i] - cloud.y[j],
                  dz = cloud.z[i] - cloud.z[j];
      const float squared = (dx * dx + dy * dy) + dz * dz;
      if (squared > 0) least = std::min(least, squared);
    }
    sum += std::sqrt(static_cast<double>(least));
  }
  return sum / static_cast<double>(queries);
}

TEST(Spacing, IsExactWhereverThePointsCrowd) {
  emtr::Cloud twins = emtr_test::uniform_cloud(400, 2);
  for (std::size_t i = 0; i < 100; ++i) emtr_test::push(twins, twins.x[i], twins.y[i], twins.z[i]);
  emtr::Cloud crowd = emtr_test::uniform_cloud(2000, 3, 0.001f);  // all in one cell but two
  emtr_test::push(crowd, 0.9f, -0.8f, 0.7f);
  emtr_test::push(crowd, -0.9f, 0.8f, 0.7f);
  const emtr_test::Pair pair(4, 5000);
  const auto normalized = emtr::normalize(pair.source(), pair.target(), 1);
  for (const emtr::Cloud& cloud : {twins, crowd, normalized.source})
    for (const std::size_t most : {100000u, 700u})
      EXPECT_EQ(emtr::mean_spacing(cloud, most),
                spacing_by_brute_force(cloud, std::max<std::size_t>(1, cloud.size() / most)));
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
