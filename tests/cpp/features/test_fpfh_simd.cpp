#include <gtest/gtest.h>

#include <cstring>
#include <utility>

#include "correspondences/matching.h"
#include "support/dense.h"
#include "support/feature_difference.h"

namespace {

using emtr::Cloud;
using emtr::FeatureBackend;
using emtr::FeatureDefinition;
using emtr::Features;
using emtr_test::Dense;
using emtr_test::feature_difference;
using emtr_test::FeatureDifference;

Features described(const Cloud& cloud, FeatureDefinition definition, FeatureBackend backend,
                   const emtr::Kernels& kernels = emtr::select_kernels()) {
  definition.backend = backend;
  return emtr::describe(cloud, definition, kernels, 1);
}

Cloud rotated(const Cloud& cloud) {
  constexpr float R[9] = {0.36f, 0.48f, -0.8f, -0.8f, 0.6f, 0, 0.48f, 0.64f, 0.6f}, t[3] = {};
  Cloud out;
  out.resize(cloud.size());
  emtr::select_kernels().transform(cloud.view(), R, t, out.x.data(), out.y.data(), out.z.data());
  return out;
}

/// Points that share all their neighbors have one normal but for rounding, and that rounding
/// chooses the sign of PCL's third angle: rotate the cloud, and PCL disagrees with itself. So that
/// is the measure for how far the kernels may disagree with it.
void expect_small_difference(const Cloud& cloud, const FeatureDefinition& definition) {
  const Features pcl = described(cloud, definition, FeatureBackend::Pcl);
  const Features simd = described(cloud, definition, FeatureBackend::Simd);
  const FeatureDifference both = feature_difference(pcl, simd);
  const FeatureDifference itself =
      feature_difference(pcl, described(rotated(cloud), definition, FeatureBackend::Pcl));
  const FeatureDifference simd_itself =
      feature_difference(simd, described(rotated(cloud), definition, FeatureBackend::Simd));
  testing::Test::RecordProperty("moved", std::to_string(both.share()));
  testing::Test::RecordProperty("largest", std::to_string(both.largest));
  EXPECT_EQ(both.only_one, 0u);
  EXPECT_LT(both.angle(0.5), 5e-7);
  EXPECT_LT(both.angle(0.99), 1e-4);
  EXPECT_LT(both.share(), 0.01 + 1.2 * itself.share());
  for (const int part : {0, 1})
    EXPECT_LT(both.part_share(part), 0.02 + 1.2 * itself.part_share(part)) << part;
  EXPECT_LT(both.largest, 15);
  EXPECT_LT(simd_itself.share(), 0.03);  // a few pairs of points on an edge between two bins
  EXPECT_LT(simd_itself.part_share(2), 0.04);
}

void expect_the_same_matches(const Dense& d) {
  std::vector<emtr::Correspondence> matches[2];
  for (const auto backend : {FeatureBackend::Pcl, FeatureBackend::Simd})
    matches[static_cast<int>(backend)] =
        emtr::match(described(d.source, d.definition, backend),
                    described(d.target, d.definition, backend), 10000, emtr::select_kernels(), 1);
  std::size_t same = 0;
  for (const auto& a : matches[0])
    for (const auto& b : matches[1]) same += a.source == b.source && a.target == b.target;
  EXPECT_GE(matches[0].size(), 100u);
  EXPECT_GE(static_cast<double>(same), 0.97 * static_cast<double>(matches[0].size()));
  EXPECT_GE(static_cast<double>(same), 0.97 * static_cast<double>(matches[1].size()));
}

TEST(FpfhSimd, AgreesWithPclOnGeneratedClouds) {
  const Dense d = emtr_test::dense(emtr_test::Pair(3));
  expect_small_difference(d.source, d.definition);
  expect_small_difference(d.target, d.definition);
  expect_the_same_matches(d);
}

TEST(FpfhSimd, AgreesWithPclInAVolume) {  // neighbors on all sides
  FeatureDefinition definition;
  definition.normal_radius = 0.2;
  definition.feature_radius = 0.4;
  expect_small_difference(emtr_test::uniform_cloud(2000, 6), definition);
}

class FpfhSimdOnRealPairs : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Data, FpfhSimdOnRealPairs, testing::ValuesIn(emtr_test::kRealPairs));

TEST_P(FpfhSimdOnRealPairs, AgreesWithPcl) {
  if (!emtr_test::RealPair::available()) GTEST_SKIP() << "EMTR_DATA is not set";
  const Dense d = emtr_test::dense(emtr_test::RealPair(GetParam()));
  expect_small_difference(d.source, d.definition);
  expect_the_same_matches(d);
}

TEST(FpfhSimd, IsTheSameBitsInEachKernel) {
  const Dense d = emtr_test::dense(emtr_test::Pair(5));
  FeatureDefinition wide;  // lists longer than what the kernels look at in one go
  wide.normal_radius = wide.feature_radius = 3;
  Cloud flat = emtr_test::uniform_cloud(1103, 8, 1, 0);
  for (const auto& [cloud, definition] : {std::pair{d.source, d.definition},
                                          {emtr_test::uniform_cloud(1201, 7), wide},
                                          {flat, FeatureDefinition{0.1, 0.3}}}) {
    const Features first = described(cloud, definition, FeatureBackend::Simd, *emtr::kernels_at(0));
    for (const emtr::Kernels* k : emtr_test::kernels_here()) {
      const Features other = described(cloud, definition, FeatureBackend::Simd, *k);
      EXPECT_FALSE(std::memcmp(first.normals.data(), other.normals.data(),
                               first.normals.size() * sizeof(float)))
          << k->name;
      EXPECT_FALSE(std::memcmp(first.descriptors.data(), other.descriptors.data(),
                               first.descriptors.size() * sizeof(float)))
          << k->name;
    }
  }
}

}  // namespace
