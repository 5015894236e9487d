#include <gtest/gtest.h>

#include <vector>

#include "neighbors/resolution.h"
#include "preprocessing/downsampling.h"
#include "support/clouds.h"
#include "support/lidar_street.h"
#include "util/error.h"

namespace {

double dense_points(const emtr::DownsampledClouds& d) {
  return static_cast<double>(d.source_dense.size() + d.target_dense.size());
}

double sparse_points(const emtr::DownsampledClouds& d) {
  return static_cast<double>(d.source_sparse.size());
}

emtr::DownsampledClouds downsampled(std::size_t points, const char* setting = "seed",
                                    double value = 0) {
  const emtr_test::Pair pair(1, points);
  emtr::Settings settings = emtr::preset("paper");
  emtr::set(settings, setting, value);
  return emtr::downsample(emtr::normalize(pair.source(), pair.target(), 1), settings);
}

TEST(DownsampledClouds, MeetTheCountsWhateverTheSizeOfTheInput) {
  for (const std::size_t points : {12000u, 60000u}) {
    const auto d = downsampled(points);
    EXPECT_NEAR(dense_points(d), 4000, 40);
    EXPECT_NEAR(sparse_points(d), 600, 6);
    EXPECT_GT(d.leaf_sparse, d.leaf_dense);
  }
}

TEST(DownsampledClouds, FollowTheSettings) {
  EXPECT_NEAR(sparse_points(downsampled(30000, "sparse_points", 300)), 300, 4);
  const auto d = downsampled(30000, "dense_points", 2000);
  EXPECT_NEAR(dense_points(d), 2000, 20);
}

TEST(DownsampledClouds, KeepTheLeafAboveTheSpacingOfSmallClouds) {
  const emtr_test::Pair pair(2, 1024);
  const auto normalized = emtr::normalize(pair.source(), pair.target(), 1);
  const auto d = emtr::downsample(normalized, emtr::preset("paper"));
  const double spacing =
      std::max(emtr::mean_resolution(normalized.source), emtr::mean_resolution(normalized.target));
  EXPECT_GE(d.leaf_dense, 1.49 * spacing);
  EXPECT_LT(dense_points(d), 2000);
  EXPECT_NEAR(sparse_points(d) / dense_points(d), 0.15, 0.01);
}

TEST(DownsampledClouds, KeepTheLeafAboveTheSpacingOfTheSparserCloud) {
  for (const std::size_t points : {12000u, 40000u}) {
    const emtr_test::Pair sparse(2, 1024), dense(2, points);
    const auto normalized = emtr::normalize(sparse.source(), dense.target(), 1);
    const auto d = emtr::downsample(normalized, emtr::preset("paper"));
    EXPECT_GE(d.leaf_dense, 1.49 * emtr::mean_resolution(normalized.source)) << points;
  }
}

TEST(DownsampledClouds, GrowTheLeafWhereACloudIsRingsHoweverFewTheirPoints) {
  for (const int steps : {900, 1800}) {
    const emtr::Cloud street = emtr_test::scan_street(steps).points;
    std::vector<float> rows;
    for (std::size_t i = 0; i < street.size(); ++i)
      rows.insert(rows.end(), {street.x[i], street.y[i], street.z[i]});
    const emtr_cloud cloud{rows.data(), street.size(), 0, EMTR_FLOAT32};
    const auto pair = emtr::normalize(cloud, cloud, 1);
    const auto leaf = [&](double growth) {
      emtr::Settings settings = emtr::preset("default");
      emtr::set(settings, "maximum_leaf_growth", growth);
      return emtr::downsample(pair, settings).leaf_dense;
    };
    EXPECT_GT(leaf(4), 2 * leaf(1)) << steps;
  }
}

TEST(DownsampledClouds, NameACloudThatVanishesBesideTheOther) {
  const emtr_test::Pair small(3, 2000, 1e-4), large(3, 2000, 1);
  try {
    emtr::downsample(emtr::normalize(small.source(), large.target(), 1), emtr::preset("paper"));
    FAIL() << "no error";
  } catch (const emtr::Error& error) {
    EXPECT_EQ(error.status(), EMTR_ERROR_CLOUD);
    EXPECT_EQ(std::string(error.what()).rfind("source cloud", 0), 0u) << error.what();
  }
}

}  // namespace
