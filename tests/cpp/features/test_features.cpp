#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "features/fpfh.h"
#include "features/resolution.h"
#include "support/clouds.h"

namespace {

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

bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {  // NaN is like NaN
  return a.size() == b.size() && !std::memcmp(a.data(), b.data(), a.size() * sizeof(float));
}

TEST(Features, NormalsOfASpherePointToItsCentre) {
  const emtr::Cloud cloud = sphere(2000);
  const emtr::Features f = emtr::describe(cloud, 0.15, 0.3, 2);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const float* n = &f.normals[3 * i];
    EXPECT_LT(n[0] * cloud.x[i] + n[1] * cloud.y[i] + n[2] * cloud.z[i], -0.99f);
  }
}

TEST(Features, DescriptorsAreThreeHistogramsOfOneHundred) {
  const emtr::Cloud cloud = sphere(1000);
  const emtr::Features f = emtr::describe(cloud, 0.2, 0.4, 1);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    for (int part = 0; part < 3; ++part) {
      float sum = 0;
      for (int b = 0; b < 11; ++b)
        sum += f.descriptors[33 * i + 11 * static_cast<std::size_t>(part) +
                             static_cast<std::size_t>(b)];
      EXPECT_NEAR(sum, 100, 0.01);
    }
}

TEST(Features, LonelyPointsHaveNone) {
  emtr::Cloud cloud = sphere(500);
  emtr_test::push(cloud, 5, 5, 5);  // alone
  const emtr::Features f = emtr::describe(cloud, 0.3, 0.5, 1);
  EXPECT_TRUE(f.valid(0));
  EXPECT_FALSE(f.valid(500));
  EXPECT_TRUE(std::isnan(f.normals[3 * 500]));
}

TEST(Features, AreTheSameBitsForAnyThreads) {
  const emtr::Cloud cloud = emtr_test::uniform_cloud(1500, 5);
  const emtr::Features one = emtr::describe(cloud, 0.2, 0.4, 1);
  for (const int threads : {2, 4, 8}) {
    const emtr::Features more = emtr::describe(cloud, 0.2, 0.4, threads);
    EXPECT_TRUE(same_bits(one.normals, more.normals));
    EXPECT_TRUE(same_bits(one.descriptors, more.descriptors));
  }
}

TEST(Resolution, IsTheMeanDistanceToTheNearestOther) {
  emtr::Cloud cloud;
  for (const float x : {0.0f, 1.0f, 3.0f}) emtr_test::push(cloud, x, 0, 0);
  EXPECT_DOUBLE_EQ(emtr::mean_resolution(cloud), (1.0 + 1.0 + 2.0) / 3);
}

}  // namespace
