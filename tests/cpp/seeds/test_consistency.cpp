#include <gtest/gtest.h>

#include <cmath>

#include "seeds/consistency.h"
#include "support/clouds.h"

namespace {

std::vector<emtr::Correspondence> diagonal(std::size_t n) {
  std::vector<emtr::Correspondence> out;
  for (std::size_t i = 0; i < n; ++i)
    out.push_back({static_cast<std::int32_t>(i), static_cast<std::int32_t>(i)});
  return out;
}

double length(const emtr::Cloud& c, std::size_t i, std::size_t j) {
  return std::hypot(double{c.x[j]} - double{c.x[i]}, double{c.y[j]} - double{c.y[i]},
                    double{c.z[j]} - double{c.z[i]});
}

class ConsistencyOf : public ::testing::TestWithParam<std::size_t> {};

TEST_P(ConsistencyOf, AllPairsIsWhatLengthsSay) {
  const std::size_t n = GetParam();
  const double threshold = 0.3;
  const emtr::Cloud p = emtr_test::uniform_cloud(n, 1), q = emtr_test::uniform_cloud(n, 2);
  for (const emtr::Kernels* kernels : emtr_test::kernels_here()) {
    const emtr::Consistency c(p, q, diagonal(n), threshold, *kernels, 2);
    for (std::size_t i = 0; i < n; ++i) {
      std::size_t degree = 0;
      for (std::size_t j = 0; j < n; ++j) {
        const double apart = std::abs(length(p, i, j) - length(q, i, j));
        if (std::abs(apart - threshold) > 1e-5) {
          ASSERT_EQ(c(i, j), i != j && apart < threshold) << i << " " << j;
        }
        degree += c(i, j);
        std::size_t common = 0;
        for (std::size_t k = 0; k < n; ++k) common += c(i, k) && c(j, k);
        ASSERT_EQ(c.common(i, j), common);
      }
      ASSERT_EQ(c.degree(i), degree);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, ConsistencyOf, ::testing::Values(1, 2, 15, 63, 64, 65, 100));

TEST(Consistency, OfNothingIsEmpty) {
  const emtr::Cloud p = emtr_test::uniform_cloud(3, 1);
  EXPECT_EQ(emtr::Consistency(p, p, {}, 0.1, emtr::select_kernels(), 1).size(), 0u);
}

}  // namespace
