#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "features/fpfh.h"
#include "support/clouds.h"

namespace {

using emtr::FeatureBackend;
using emtr::Features;

emtr::Cloud sphere(std::size_t n) {
  emtr::Cloud cloud;
  for (std::size_t i = 0; i < n; ++i) {
    const double a = static_cast<double>(i) * 2.399963,
                 z = 2 * (static_cast<double>(i) + 0.5) / static_cast<double>(n) - 1;
    const double r = std::sqrt(1 - z * z);
    emtr_test::push(cloud, static_cast<float>(r * std::cos(a)), static_cast<float>(r * std::sin(a)),
                    static_cast<float>(z));
  }
  return cloud;
}

/// Hills over the square [-1, 1]^2, seen from above or below.
emtr::Cloud hills(std::size_t n) {
  emtr::Cloud cloud = emtr_test::uniform_cloud(n, 9);
  for (std::size_t i = 0; i < n; ++i)
    cloud.z[i] = 0.1f * std::sin(5 * cloud.x[i]) * std::cos(4 * cloud.y[i]);
  return cloud;
}

bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {  // NaN is like NaN
  return a.size() == b.size() && !std::memcmp(a.data(), b.data(), a.size() * sizeof(float));
}

/// What holds whoever computes the features.
class BothBackends : public testing::TestWithParam<FeatureBackend> {
 protected:
  static Features described(const emtr::Cloud& cloud, double normal_radius, double feature_radius,
                            int threads = 1, std::array<float, 3> viewpoint = {0, 0, 0}) {
    return emtr::describe(cloud, {normal_radius, feature_radius, viewpoint, GetParam()},
                          emtr::select_kernels(), threads);
  }
};

INSTANTIATE_TEST_SUITE_P(Features, BothBackends,
                         testing::Values(FeatureBackend::Pcl, FeatureBackend::Simd),
                         [](const auto& instance) {
                           return instance.param == FeatureBackend::Pcl ? "pcl" : "simd";
                         });

TEST_P(BothBackends, NormalsOfASpherePointToItsCentre) {
  const emtr::Cloud cloud = sphere(2000);
  const Features f = described(cloud, 0.15, 0.3, 2);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const float* n = &f.normals[3 * i];
    EXPECT_LT(n[0] * cloud.x[i] + n[1] * cloud.y[i] + n[2] * cloud.z[i], -0.99f);
    EXPECT_NEAR(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1, 1e-5);
  }
}

TEST_P(BothBackends, NormalsPointToTheViewpoint) {
  const emtr::Cloud cloud = sphere(2000);
  const Features f = described(cloud, 0.15, 0.3, 1, {3, 1, -2});
  std::size_t outwards = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const float* n = &f.normals[3 * i];
    EXPECT_GE((3 - cloud.x[i]) * n[0] + (1 - cloud.y[i]) * n[1] + (-2 - cloud.z[i]) * n[2], 0);
    outwards += n[0] * cloud.x[i] + n[1] * cloud.y[i] + n[2] * cloud.z[i] > 0;
  }
  EXPECT_GT(outwards, 500u);  // those on the viewpoint's side
  EXPECT_LT(outwards, 1500u);
}

TEST_P(BothBackends, DescriptorsAreThreeHistogramsOfOneHundred) {
  const emtr::Cloud cloud = sphere(1000);
  const Features f = described(cloud, 0.2, 0.4);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    for (int part = 0; part < 3; ++part) {
      float sum = 0;
      for (int b = 0; b < 11; ++b)
        sum += f.descriptors[33 * i + 11 * static_cast<std::size_t>(part) +
                             static_cast<std::size_t>(b)];
      EXPECT_NEAR(sum, 100, 0.01);
    }
}

TEST_P(BothBackends, LonelyPointsHaveNone) {
  emtr::Cloud cloud = sphere(500);
  emtr_test::push(cloud, 5, 5, 5);  // alone
  const Features f = described(cloud, 0.3, 0.5);
  EXPECT_TRUE(f.valid(0));
  EXPECT_FALSE(f.valid(500));
  EXPECT_TRUE(std::isnan(f.normals[3 * 500]));
}

TEST_P(BothBackends, PointsOnALineOrOnOnePointHaveNone) {
  emtr::Cloud cloud = sphere(500);
  for (int k = 0; k < 5; ++k) emtr_test::push(cloud, 5 + 0.125f * static_cast<float>(k), 5, 5);
  for (int k = 0; k < 4; ++k) emtr_test::push(cloud, -5, 5, 5);
  for (int k = 0; k < 2; ++k) emtr_test::push(cloud, -5, -5, static_cast<float>(k) / 8);
  const Features f = described(cloud, 0.3, 0.5);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    EXPECT_EQ(std::isnan(f.normals[3 * i]), i >= 500) << i;
    EXPECT_EQ(f.valid(i), i < 500) << i;
  }
}

TEST_P(BothBackends, TwinPointsAreNoPair) {
  emtr::Cloud cloud = sphere(400);
  for (std::size_t i = 0; i < 50; ++i) emtr_test::push(cloud, cloud.x[i], cloud.y[i], cloud.z[i]);
  const Features f = described(cloud, 0.3, 0.5);
  for (std::size_t i = 0; i < cloud.size(); ++i) EXPECT_TRUE(f.valid(i)) << i;
  EXPECT_TRUE(std::equal(&f.descriptors[0], &f.descriptors[33], &f.descriptors[33 * 400]));
}

TEST_P(BothBackends, TheLargerRadiusMayBeTheSame) {
  const Features f = described(sphere(500), 0.4, 0.4);
  for (std::size_t i = 0; i < 500; ++i) EXPECT_TRUE(f.valid(i));
}

TEST_P(BothBackends, AreTheSameBitsForAnyThreads) {
  const emtr::Cloud cloud = emtr_test::uniform_cloud(1500, 5);
  const Features one = described(cloud, 0.2, 0.4, 1);
  for (const int threads : {2, 4, 8}) {
    const Features more = described(cloud, 0.2, 0.4, threads);
    EXPECT_TRUE(same_bits(one.normals, more.normals));
    EXPECT_TRUE(same_bits(one.descriptors, more.descriptors));
  }
}

TEST_P(BothBackends, MirroredAreThoseOfReversedNormals) {
  const emtr::Cloud cloud = hills(2000);
  const Features above = described(cloud, 0.1, 0.25, 1, {0, 0, 50});
  const Features below = described(cloud, 0.1, 0.25, 1, {0, 0, -50});
  const Features reversed = emtr::mirrored(above);
  EXPECT_TRUE(same_bits(emtr::mirrored(reversed).descriptors, above.descriptors));
  std::size_t moved = 0, differ = 0;
  for (std::size_t i = 0; i < above.normals.size(); ++i) {
    ASSERT_EQ(reversed.normals[i], below.normals[i]);
    ASSERT_EQ(reversed.normals[i], -above.normals[i]);
  }
  for (std::size_t i = 0; i < above.descriptors.size(); ++i) {
    moved += std::abs(reversed.descriptors[i] - below.descriptors[i]) > 1e-3f;
    differ += std::abs(reversed.descriptors[i] - above.descriptors[i]) > 1e-3f;
  }
  EXPECT_LT(moved, above.descriptors.size() / 500);
  EXPECT_GT(differ, above.descriptors.size() / 10);  // or the test says nothing
}

}  // namespace
