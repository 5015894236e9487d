#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "features/matching.h"

namespace {

emtr::Features random_features(std::size_t n, unsigned seed) {
  std::mt19937 random(seed);
  emtr::Features f;
  f.descriptors.resize(n * emtr::kFeatureSize);
  for (float& v : f.descriptors) v = static_cast<float>(random() % 10000) / 100;
  return f;
}

double squared(const emtr::Features& a, std::size_t i, const emtr::Features& b, std::size_t j) {
  double sum = 0;
  for (std::size_t k = 0; k < emtr::kFeatureSize; ++k) {
    const double d = double{a.descriptors[33 * i + k]} - double{b.descriptors[33 * j + k]};
    sum += d * d;
  }
  return sum;
}

std::size_t nearest(const emtr::Features& a, std::size_t i, const emtr::Features& b,
                    std::size_t n) {
  std::size_t best = 0;
  for (std::size_t j = 1; j < n; ++j)
    if (squared(a, i, b, j) < squared(a, i, b, best)) best = j;
  return best;
}

TEST(Matching, FindsTheMutualNearestAndTheBestFirst) {
  const emtr::Features a = random_features(80, 1), b = random_features(120, 2);
  std::vector<std::pair<double, std::size_t>> expected;
  for (std::size_t i = 0; i < 80; ++i) {
    const std::size_t j = nearest(a, i, b, 120);
    if (nearest(b, j, a, 80) == i) expected.emplace_back(squared(a, i, b, j), i);
  }
  std::sort(expected.begin(), expected.end());
  const auto all = emtr::match(a, b, 1000, 2);
  ASSERT_EQ(all.size(), expected.size());
  ASSERT_GT(all.size(), 10u);
  for (std::size_t k = 0; k < all.size(); ++k)
    EXPECT_EQ(static_cast<std::size_t>(all[k].source), expected[k].second);

  const auto few = emtr::match(a, b, 10, 1);
  ASSERT_EQ(few.size(), 10u);
  for (std::size_t k = 0; k < 10; ++k) EXPECT_EQ(few[k].target, all[k].target);
}

TEST(Matching, PassesOverPointsWithoutADescriptor) {
  emtr::Features a = random_features(30, 3);
  const emtr::Features b = a;
  std::fill_n(&a.descriptors[33 * 4], 33, std::numeric_limits<float>::quiet_NaN());
  const auto matches = emtr::match(a, b, 1000, 1);
  EXPECT_EQ(matches.size(), 29u);
  for (const auto& m : matches) EXPECT_EQ(m.source, m.target);
}

TEST(Matching, OfNothingIsNothing) {
  emtr::Features none = random_features(3, 4);
  std::fill(none.descriptors.begin(), none.descriptors.end(),
            std::numeric_limits<float>::quiet_NaN());
  EXPECT_TRUE(emtr::match(none, random_features(5, 5), 10, 1).empty());
}

}  // namespace
