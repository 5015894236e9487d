#include <gtest/gtest.h>
#include <pcl/pcl_config.h>

#include <cstring>

#include "support/dense.h"
#include "support/pcl_features.h"
#include "support/pcl_rounding.h"

namespace {

using emtr::Cloud;
using emtr::FeatureDefinition;

void expect_the_same_bits(const Cloud& cloud, const FeatureDefinition& definition) {
  if (emtr_test::kPclContracts) GTEST_SKIP() << emtr_test::kNoOracle;
  const emtr::Features expected = emtr_test::by_classes_of_pcl(cloud, definition);
  for (const int threads : {1, 3}) {
    const emtr::Features found = emtr::describe(cloud, definition, emtr::select_kernels(), threads);
    ASSERT_EQ(found.normals.size(), expected.normals.size());
    ASSERT_EQ(found.descriptors.size(), expected.descriptors.size());
    EXPECT_EQ(0, std::memcmp(found.normals.data(), expected.normals.data(),
                             expected.normals.size() * sizeof(float)));
    EXPECT_EQ(0, std::memcmp(found.descriptors.data(), expected.descriptors.data(),
                             expected.descriptors.size() * sizeof(float)));
  }
}

TEST(FpfhPcl, IsTheSameBitsAsTheClassesOnGeneratedClouds) {
  const auto d = emtr_test::dense(emtr_test::Pair(3));
  expect_the_same_bits(d.source, d.definition);
  expect_the_same_bits(d.target, d.definition);
  FeatureDefinition seen = d.definition;
  seen.viewpoint = {0.5f, -2, 3};
  expect_the_same_bits(d.source, seen);
}

TEST(FpfhPcl, IsTheSameBitsWhereDistancesAreEqualOrPointsAreLonely) {
  Cloud cloud = emtr_test::uniform_cloud(700, 6);
  for (int i = 0; i < 12; ++i)  // a lattice: the order of the neighbors is by row
    for (int j = 0; j < 12; ++j)
      emtr_test::push(cloud, 0.125f * static_cast<float>(i), 0.125f * static_cast<float>(j % 12),
                      3 + 0.03125f * static_cast<float>(i * j % 4));
  for (std::size_t i = 0; i < 60; ++i)  // twins
    emtr_test::push(cloud, cloud.x[7 * i], cloud.y[7 * i], cloud.z[7 * i]);
#if PCL_VERSION_COMPARE(<, 1, 15, 0)  // later ones may find a normal on a line
  for (int k = 0; k < 4; ++k) emtr_test::push(cloud, static_cast<float>(k) / 8, 9, 9);
#endif
  emtr_test::push(cloud, -9, 9, 9);
  FeatureDefinition definition;
  definition.normal_radius = 0.25;
  definition.feature_radius = 0.5;
  expect_the_same_bits(cloud, definition);
  definition.feature_radius = 0.25;
  expect_the_same_bits(cloud, definition);
  definition.feature_radius = 30;  // everything
  expect_the_same_bits(cloud, definition);
}

class FpfhPclOnRealPairs : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Data, FpfhPclOnRealPairs, testing::ValuesIn(emtr_test::kRealPairs));

TEST_P(FpfhPclOnRealPairs, IsTheSameBitsAsTheClasses) {
  if (!emtr_test::RealPair::available()) GTEST_SKIP() << "EMTR_DATA is not set";
  const auto d = emtr_test::dense(emtr_test::RealPair(GetParam()));
  expect_the_same_bits(d.source, d.definition);
  expect_the_same_bits(d.target, d.definition);
}

}  // namespace
