#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "preprocessing/color_reader.h"
#include "preprocessing/preprocessed_cloud.h"
#include "support/clouds.h"
#include "util/error.h"

namespace {

using emtr::ColorKind;
using emtr::ColorReader;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

TEST(ColorReader, ReadsAMeanAndTwoDifferences) {
  const float rgb[] = {0.9f, 0.6f, 0.3f, 0.5f, 0.5f, 0.5f};
  emtr_cloud cloud{};
  cloud.colors = rgb;
  const auto reader = ColorReader::of(cloud, "cloud");
  ASSERT_TRUE(reader);
  EXPECT_EQ(reader->kind(), ColorKind::Colors);
  float c[3];
  reader->read(0, c);
  EXPECT_FLOAT_EQ(c[0], 0.6f);
  EXPECT_FLOAT_EQ(c[1], 0.3f);
  EXPECT_FLOAT_EQ(c[2], 0.45f);
  reader->read(1, c);
  EXPECT_FLOAT_EQ(c[0], 0.5f);
  EXPECT_FLOAT_EQ(c[1], 0);
  EXPECT_FLOAT_EQ(c[2], 0);
}

TEST(ColorReader, TakesColorsBeforeIntensities) {
  const float rgb[] = {1, 1, 1}, intensity[] = {7};
  emtr_cloud cloud{};
  EXPECT_FALSE(ColorReader::of(cloud, "cloud"));
  cloud.intensities = intensity;
  EXPECT_EQ(ColorReader::of(cloud, "cloud")->kind(), ColorKind::Intensities);
  cloud.colors = rgb;
  EXPECT_EQ(ColorReader::of(cloud, "cloud")->kind(), ColorKind::Colors);
}

TEST(ColorReader, KnowsPointsWithoutAColor) {
  const float rgb[] = {0.9f, kNan, 0.3f}, intensity[] = {-1, kNan, 0};
  emtr_cloud colored{}, measured{};
  colored.colors = rgb;
  measured.intensities = intensity;
  float c[3];
  ColorReader::of(colored, "cloud")->read(0, c);
  EXPECT_TRUE(std::isnan(c[0]));
  const auto reader = ColorReader::of(measured, "cloud");
  for (const std::size_t row : {0, 1}) {
    reader->read(row, c);
    EXPECT_TRUE(std::isnan(c[0])) << row;
  }
  reader->read(2, c);
  EXPECT_EQ(c[0], 0);
}

TEST(ColorReader, RefusesAStrideThatIsTooShort) {
  const float rgb[] = {1, 1, 1};
  emtr_cloud cloud{};
  cloud.colors = rgb;
  cloud.color_stride = 8;
  EXPECT_THROW(ColorReader::of(cloud, "cloud"), emtr::Error);
  cloud.color_stride = 12;
  EXPECT_NO_THROW(ColorReader::of(cloud, "cloud"));
  cloud.intensity_stride = 2;
  EXPECT_THROW(ColorReader::of(cloud, "cloud"), emtr::Error);
}

/// A cloud with a color that is its place, of either size.
emtr::PreprocessedCloud colored_by_place(std::size_t n) {
  const emtr::Cloud points = emtr_test::uniform_cloud(n, 5);
  std::vector<float> rows, colors;
  for (std::size_t i = 0; i < n; ++i) {
    rows.insert(rows.end(), {points.x[i], points.y[i], points.z[i]});
    const float shade = (points.x[i] + 1) / 2;
    colors.insert(colors.end(), {shade, shade, shade});
  }
  emtr_cloud view{rows.data(), n, 0, EMTR_FLOAT32};
  view.colors = colors.data();
  return {view, "", 1};
}

TEST(PreprocessedColors, BelongToTheirPointsInCloudsOfAllSizes) {
  for (const std::size_t n : {2000, 300000}) {
    const emtr::PreprocessedCloud cloud = colored_by_place(n);
    ASSERT_EQ(cloud.colors.size(), cloud.base.size());
    EXPECT_EQ(cloud.color_kind, ColorKind::Colors);
    for (std::size_t i = 0; i < cloud.base.size(); i += 7) {
      const double x = cloud.base.x[i] * cloud.radius + cloud.center[0];
      EXPECT_NEAR(cloud.colors.x[i], (x + 1) / 2, 1e-4);
    }
  }
}

}  // namespace
