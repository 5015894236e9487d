#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <string>

#include "correspondences/nearest_descriptors.h"
#include "correspondences/principal_blocks.h"
#include "support/clouds.h"

namespace {

using emtr::DescriptorRows;
using emtr::NearestBothWays;

/// Descriptors around some centers, so that there is something to leave out; every tenth is twice
/// there, so that distances are equal.
std::vector<float> clustered(std::size_t n, std::size_t dimension, unsigned seed, float scale) {
  std::mt19937 random(7);  // the same centers for both sides
  std::vector<float> centers(20 * dimension);
  for (float& value : centers) value = static_cast<float>(random() % 1000) / 10;
  random.seed(seed);
  std::vector<float> out(n * dimension);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t center = random() % 20;
    for (std::size_t d = 0; d < dimension; ++d)
      out[i * dimension + d] =
          scale * (centers[center * dimension + d] + static_cast<float>(random() % 200) / 20);
    if (i % 10 == 9) std::copy_n(&out[(i - 9) * dimension], dimension, &out[i * dimension]);
  }
  return out;
}

void expect_same(const emtr::Nearest& a, const emtr::Nearest& b, std::size_t items) {
  ASSERT_EQ(a.k, b.k);
  for (std::size_t j = 0; j < a.k; ++j)
    for (std::size_t i = 0; i < items; ++i) {
      ASSERT_EQ(a.squared[j * a.n + i], b.squared[j * b.n + i]) << i << ", " << j;
      ASSERT_EQ(a.index[j * a.n + i], b.index[j * b.n + i]) << i << ", " << j;
    }
}

void expect_all_with_all(const std::vector<float>& a, const std::vector<float>& b,
                         std::size_t dimension, std::size_t k) {
  const DescriptorRows source(a, dimension), target(b, dimension);
  const auto rows = emtr::rows_with_descriptor(source),
             columns = emtr::rows_with_descriptor(target);
  for (const emtr::Kernels* kernels : emtr_test::kernels_here())
    for (const int threads : {1, 3}) {
      SCOPED_TRACE(std::string(kernels->name) + ", threads " + std::to_string(threads));
      const NearestBothWays all =
          emtr::compare_all_descriptors(source, rows, target, columns, k, *kernels, threads);
      const NearestBothWays found =
          emtr::find_nearest_descriptors(source, rows, target, columns, k, *kernels, threads);
      expect_same(all.forward, found.forward, rows.size());
      expect_same(all.backward, found.backward, columns.size());
    }
}

TEST(NearestDescriptors, AreTheBitsOfAllWithAll) {
  for (const std::size_t dimension : {16u, 33u, 40u})
    for (const std::size_t k : {1u, 3u, 10u})
      expect_all_with_all(clustered(700, dimension, 1, 1), clustered(525, dimension, 2, 1),
                          dimension, k);
}

TEST(NearestDescriptors, AreSoOfAnySizeAndUnit) {
  for (const std::size_t count : {1u, 31u, 33u, 64u})
    expect_all_with_all(clustered(count, 33, 3, 1), clustered(1500, 33, 4, 1), 33, 2);
  for (const float scale : {1e-12f, 1e12f, 1e30f})
    expect_all_with_all(clustered(400, 33, 5, scale), clustered(300, 33, 6, scale), 33, 2);
}

TEST(NearestDescriptors, AreSoOfEqualOnesAndOfNumbersThatAreNotFinite) {
  const std::vector<float> equal(33 * 300, 1.5f);
  expect_all_with_all(equal, equal, 33, 3);
  std::vector<float> broken = clustered(300, 33, 8, 1);
  broken[33 * 4] = std::numeric_limits<float>::quiet_NaN();  // no descriptor
  broken[33 * 7 + 5] = std::numeric_limits<float>::quiet_NaN();
  broken[33 * 9 + 6] = std::numeric_limits<float>::infinity();
  expect_all_with_all(broken, clustered(300, 33, 9, 1), 33, 3);
}

TEST(PrincipalBlocks, HoldEachDescriptorOnceNearItsLikes) {
  const std::vector<float> numbers = clustered(500, 33, 10, 1);
  const DescriptorRows features(numbers, 33);
  const auto rows = emtr::rows_with_descriptor(features);
  const emtr::PrincipalBasis basis(features, rows, features, rows);
  const emtr::PrincipalBlocks blocks(features, rows, basis);
  ASSERT_EQ(blocks.size(), 16u);
  std::vector<std::int32_t> order = blocks.order();
  std::sort(order.begin(), order.end());
  EXPECT_EQ(order.front(), -1);
  EXPECT_EQ(order.back(), 499);
  EXPECT_EQ(std::count(order.begin(), order.end(), -1), 12);
  // No box is farther from another one than the descriptors within are.
  for (std::size_t b = 0; b < blocks.size(); ++b)
    for (std::size_t i = 0; i < emtr::kDescriptorBlock; ++i) {
      const std::int32_t own = blocks.block(b).index[i];
      for (std::size_t o = 0; o < blocks.size() && own >= 0; ++o) {
        const std::int32_t other = blocks.block(o).index[0];
        float squared = 0;
        for (std::size_t d = 0; d < 33; ++d) {
          const float gap = features.row(static_cast<std::size_t>(own))[d] -
                            features.row(static_cast<std::size_t>(other))[d];
          squared += gap * gap;
        }
        EXPECT_LE(blocks.squared_distance(b, blocks, o), squared * 1.001f + 0.01f);
      }
    }
}

}  // namespace
