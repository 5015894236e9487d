#include <gtest/gtest.h>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <random>
#include <tuple>
#include <utility>

#include "correspondences/matching.h"
#include "support/clouds.h"

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
  const auto all = emtr::match(a, b, 1000, emtr::select_kernels(), 2);
  ASSERT_EQ(all.size(), expected.size());
  ASSERT_GT(all.size(), 10u);
  for (std::size_t k = 0; k < all.size(); ++k)
    EXPECT_EQ(static_cast<std::size_t>(all[k].source), expected[k].second);

  const auto few = emtr::match(a, b, 10, emtr::select_kernels(), 1);
  ASSERT_EQ(few.size(), 10u);
  for (std::size_t k = 0; k < 10; ++k) EXPECT_EQ(few[k].target, all[k].target);
}

TEST(Matching, PassesOverPointsWithoutADescriptor) {
  emtr::Features a = random_features(30, 3);
  const emtr::Features b = a;
  std::fill_n(&a.descriptors[33 * 4], 33, std::numeric_limits<float>::quiet_NaN());
  const auto matches = emtr::match(a, b, 1000, emtr::select_kernels(), 1);
  EXPECT_EQ(matches.size(), 29u);
  for (const auto& m : matches) EXPECT_EQ(m.source, m.target);
}

TEST(Matching, OfNothingIsNothing) {
  emtr::Features none = random_features(3, 4);
  std::fill(none.descriptors.begin(), none.descriptors.end(),
            std::numeric_limits<float>::quiet_NaN());
  EXPECT_TRUE(emtr::match(none, random_features(5, 5), 10, emtr::select_kernels(), 1).empty());
}

using Pairs = std::vector<std::pair<std::int32_t, std::int32_t>>;

Pairs pairs(const std::vector<emtr::Correspondence>& matches) {
  Pairs out;
  for (const auto& m : matches) out.emplace_back(m.source, m.target);
  return out;
}

/// As the kernels take it: in float, in the order of the bins.
float squared_in_float(const emtr::Features& a, std::size_t i, const emtr::Features& b,
                       std::size_t j) {
  float sum = 0;
  for (std::size_t k = 0; k < emtr::kFeatureSize; ++k) {
    const float d = a.descriptors[33 * i + k] - b.descriptors[33 * j + k];
    sum += d * d;
  }
  return sum;
}

/// By sorting all of them; squared(i, j) is the distance of source i to target j.
template <class Squared>
Pairs mutual_nearest(std::size_t n, std::size_t m, std::size_t k, const Squared& squared) {
  const auto best = [k](std::size_t others, const auto& distance) {
    std::vector<std::pair<float, std::size_t>> all;
    for (std::size_t j = 0; j < others; ++j) all.emplace_back(distance(j), j);
    std::sort(all.begin(), all.end());
    all.resize(std::min(k, all.size()));
    return all;
  };
  std::vector<std::vector<std::pair<float, std::size_t>>> backward;
  for (std::size_t j = 0; j < m; ++j)
    backward.push_back(best(n, [&](std::size_t i) { return squared(i, j); }));
  std::vector<std::tuple<float, std::int32_t, std::int32_t>> found;
  for (std::size_t i = 0; i < n; ++i)
    for (const auto& [d, j] : best(m, [&](std::size_t o) { return squared(i, o); }))
      for (const auto& [e, back] : backward[j])
        if (back == i)
          found.emplace_back(d, static_cast<std::int32_t>(i), static_cast<std::int32_t>(j));
  std::sort(found.begin(), found.end());
  Pairs out;
  for (const auto& [d, i, j] : found) out.emplace_back(i, j);
  return out;
}

Pairs mutual_by_brute_force(const emtr::Features& a, std::size_t n, const emtr::Features& b,
                            std::size_t m, std::size_t k) {
  return mutual_nearest(n, m, k,
                        [&](std::size_t i, std::size_t j) { return squared_in_float(a, i, b, j); });
}

TEST(Matching, PairsAreWithinTheTopOfEachOtherInEachKernelAndForAnyThreads) {
  for (const auto& [n, m] : {std::pair{300, 411}, {411, 300}, {5, 2}, {1, 1}, {130, 2500}}) {
    const auto a = random_features(static_cast<std::size_t>(n), 7),
               b = random_features(static_cast<std::size_t>(m), 8);
    for (const int k : {1, 3, 8}) {
      const Pairs expected =
          mutual_by_brute_force(a, static_cast<std::size_t>(n), b, static_cast<std::size_t>(m),
                                static_cast<std::size_t>(k));
      ASSERT_FALSE(expected.empty());
      for (const emtr::Kernels* kernels : emtr_test::kernels_here())
        for (const int threads : {1, 2, 5})
          EXPECT_EQ(pairs(emtr::match_mutual(a, b, k, 1000000, *kernels, threads)), expected)
              << kernels->name << " " << n << " x " << m << ", k = " << k;
    }
  }
}

TEST(Matching, DescriptorsOfAnySizeAreComparedInEachKernelAndForAnyThreads) {
  // Numbers past those of the size at hand, which must not count, are the other rows'.
  for (const std::size_t dimension : {1u, 2u, 32u, 34u, 352u, 3000u}) {
    const std::size_t n = 70, m = 90;
    std::mt19937 random(static_cast<unsigned>(dimension));
    const auto draw = [&](std::size_t rows) {
      std::vector<float> values(rows * dimension);
      for (float& v : values) v = static_cast<float>(random() % 100000) / 1000;
      return values;
    };
    const auto a = draw(n), b = draw(m);
    const auto squared = [&](std::size_t i, std::size_t j) {
      float sum = 0;
      for (std::size_t d = 0; d < dimension; ++d) {
        const float off = a[dimension * i + d] - b[dimension * j + d];
        sum += off * off;
      }
      return sum;
    };
    const Pairs expected = mutual_nearest(n, m, 2, squared);
    ASSERT_FALSE(expected.empty());
    for (const emtr::Kernels* kernels : emtr_test::kernels_here())
      for (const int threads : {1, 3})
        EXPECT_EQ(pairs(emtr::match_mutual(emtr::DescriptorRows(a, dimension),
                                           emtr::DescriptorRows(b, dimension), 2, 1000000, *kernels,
                                           threads)),
                  expected)
            << kernels->name << " " << dimension;
  }
}

/// Returns the squared distance, in float, to the k-th nearest of a row.
float kth(const emtr::Features& a, std::size_t i, const emtr::Features& b, std::size_t m,
          std::size_t k) {
  std::vector<float> all;
  for (std::size_t j = 0; j < m; ++j) all.push_back(squared_in_float(a, i, b, j));
  std::nth_element(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(k - 1), all.end());
  return all[k - 1];
}

TEST(Matching, DistinctPairsAreTheMutualOnesOrderedByHowMuchTheyStandOut) {
  const auto a = random_features(150, 17), b = random_features(211, 18);
  std::vector<std::tuple<float, std::int32_t, std::int32_t>> sorted;
  for (const auto& [i, j] : mutual_by_brute_force(a, 150, b, 211, 3)) {
    const auto row = static_cast<std::size_t>(i), column = static_cast<std::size_t>(j);
    const float d = squared_in_float(a, row, b, column), f = kth(a, row, b, 211, 10),
                g = kth(b, column, a, 150, 10);
    sorted.emplace_back((d / f) * (d / g), i, j);
  }
  std::sort(sorted.begin(), sorted.end());
  Pairs expected;
  for (const auto& [key, i, j] : sorted) expected.emplace_back(i, j);
  ASSERT_GT(expected.size(), 50u);
  for (const emtr::Kernels* kernels : emtr_test::kernels_here())
    for (const int threads : {1, 3})
      EXPECT_EQ(pairs(emtr::match_distinctive(a, b, 3, 1000000, *kernels, threads)), expected);
  expected.resize(20);
  EXPECT_EQ(pairs(emtr::match_distinctive(a, b, 3, 20, emtr::select_kernels(), 2)), expected);
}

TEST(Matching, APairThatStandsOutComesBeforeNearerOnesOfACrowd) {
  emtr::Features a = random_features(30, 19), b = a;
  for (std::size_t i = 0; i < 29; ++i)  // all but the last are nearly one descriptor
    for (std::size_t k = 0; k < 33; ++k)
      for (emtr::Features* f : {&a, &b})
        f->descriptors[33 * i + k] =
            50 + 1e-3f * f->descriptors[33 * i + k] + (f == &b ? 1e-3f : 0);
  for (std::size_t k = 0; k < 33; ++k) b.descriptors[33 * 29 + k] += 0.5f;
  const auto& kernels = emtr::select_kernels();
  EXPECT_EQ(emtr::match_mutual(a, b, 3, 1000, kernels, 1).back().source, 29);
  EXPECT_EQ(emtr::match_distinctive(a, b, 3, 1000, kernels, 1).front().source, 29);
}

TEST(Matching, IdenticalDescriptorsStandOutLeast) {
  emtr::Features a = random_features(25, 20);
  for (std::size_t i = 5; i < 25; ++i)
    std::copy_n(a.descriptors.begin(), 33, &a.descriptors[33 * i]);
  const auto all = emtr::match_distinctive(a, a, 1, 1000, emtr::select_kernels(), 1);
  ASSERT_EQ(all.size(), 5u);
  EXPECT_EQ(all.back().source, 0);  // one of twenty-one
  EXPECT_TRUE(
      emtr::match_distinctive(a, emtr::Features{}, 3, 10, emtr::select_kernels(), 1).empty());
}

TEST(Matching, OfEqualDistancesTheSmallestRowIsTheNearer) {
  emtr::Features a = random_features(40, 9);
  emtr::Features twice = a;  // each descriptor again, 40 rows later
  twice.descriptors.insert(twice.descriptors.end(), a.descriptors.begin(), a.descriptors.end());
  for (const emtr::Kernels* kernels : emtr_test::kernels_here())
    for (const auto& [s, t] : {std::pair{a, twice}, {twice, a}, {twice, twice}}) {
      const auto matches = emtr::match_mutual(s, t, 1, 1000, *kernels, 3);
      EXPECT_EQ(matches.size(), 40u);
      for (const auto& m : matches) {
        EXPECT_EQ(m.source, m.target);
        EXPECT_LT(m.source, 40);
      }
      EXPECT_EQ(
          pairs(emtr::match_mutual(s, t, 3, 1000, *kernels, 2)),
          mutual_by_brute_force(s, s.descriptors.size() / 33, t, t.descriptors.size() / 33, 3));
    }
}

TEST(Matching, AgreesWithTheKdTreeOfPcl) {
  const emtr::Features a = random_features(500, 10), b = random_features(700, 11);
  const auto cloud = [](const emtr::Features& f) {
    auto out = pcl::make_shared<pcl::PointCloud<pcl::FPFHSignature33>>();
    for (std::size_t i = 0; i < f.descriptors.size(); i += 33) {
      pcl::FPFHSignature33 signature;
      std::copy_n(&f.descriptors[i], 33, signature.histogram);
      out->push_back(signature);
    }
    return out;
  };
  const auto nearest_of = [&](const emtr::Features& queries, const emtr::Features& points) {
    pcl::KdTreeFLANN<pcl::FPFHSignature33> tree;
    tree.setInputCloud(cloud(points));
    std::vector<std::int32_t> out;
    pcl::Indices index(1);
    std::vector<float> distance(1);
    const auto asked = cloud(queries);
    for (const auto& query : *asked) {
      tree.nearestKSearch(query, 1, index, distance);
      out.push_back(index[0]);
    }
    return out;
  };
  const auto forward = nearest_of(a, b), backward = nearest_of(b, a);
  Pairs expected;
  for (std::size_t i = 0; i < forward.size(); ++i)
    if (backward[static_cast<std::size_t>(forward[i])] == static_cast<std::int32_t>(i))
      expected.emplace_back(static_cast<std::int32_t>(i), forward[i]);
  Pairs found = pairs(emtr::match(a, b, 100000, emtr::select_kernels(), 2));
  std::sort(found.begin(), found.end());
  EXPECT_GT(found.size(), 50u);
  EXPECT_EQ(found, expected);
}

}  // namespace
