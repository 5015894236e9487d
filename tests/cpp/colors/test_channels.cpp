#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "colors/channels.h"
#include "colors/painted.h"

namespace {

using emtr::Channels;
using emtr_test::Painted;

const emtr_test::Patches kPatches(1);

double variance(const std::vector<float>& values) {
  double sum = 0, squares = 0;
  for (const float v : values) {
    sum += v;
    squares += v * v;
  }
  const auto n = static_cast<double>(values.size());
  return squares / n - (sum / n) * (sum / n);
}

TEST(Channels, AreBlindToTheExposure) {
  const Painted bright = emtr_test::painted_plane(kPatches, 2);
  Painted dark = bright;
  for (auto* channel : {&dark.colors.x, &dark.colors.y, &dark.colors.z})
    for (float& v : *channel) v = 0.5f * v + (channel == &dark.colors.x ? 0.1f : 0.0f);
  const Channels channels = emtr::make_channels(bright.colors, dark.colors);
  ASSERT_TRUE(channels.any());
  for (std::size_t i = 0; i < bright.points.size(); ++i) {
    EXPECT_NEAR(channels.source.x[i], channels.target.x[i], 1e-3);
    EXPECT_NEAR(channels.source.y[i], channels.target.y[i], 1e-3);
    EXPECT_NEAR(channels.source.z[i], channels.target.z[i], 1e-3);
  }
}

TEST(Channels, HaveVarianceOneWhereTheyAreUsed) {
  const Painted a = emtr_test::painted_plane(kPatches, 2),
                b = emtr_test::painted_plane(kPatches, 3);
  const Channels channels = emtr::make_channels(a.colors, b.colors);
  for (const bool used : channels.used) EXPECT_TRUE(used);
  EXPECT_NEAR(variance(channels.source.x), 1, 0.05);
  EXPECT_NEAR(variance(channels.target.z), 1, 0.05);
}

TEST(Channels, OfOneColorAreNotUsed) {
  const Painted a = emtr_test::painted_plane(kPatches, 2);
  Painted gray = a;
  for (std::size_t i = 0; i < gray.points.size(); ++i) {
    gray.colors.x[i] = 0.5f;
    gray.colors.y[i] = gray.colors.z[i] = 0;
  }
  EXPECT_FALSE(emtr::make_channels(a.colors, gray.colors).any());
}

TEST(Channels, OfAGrayscaleAreOneChannel) {
  Painted a = emtr_test::painted_plane(kPatches, 2);
  for (std::size_t i = 0; i < a.points.size(); ++i) a.colors.y[i] = a.colors.z[i] = 0;
  const Channels channels = emtr::make_channels(a.colors, a.colors);
  EXPECT_EQ(channels.used[0] + channels.used[1] + channels.used[2], 1);
}

TEST(Channels, APointWithoutAColorStaysWithout) {
  Painted a = emtr_test::painted_plane(kPatches, 2);
  a.colors.x[7] = a.colors.y[7] = a.colors.z[7] = std::numeric_limits<float>::quiet_NaN();
  const Channels channels = emtr::make_channels(a.colors, a.colors);
  EXPECT_TRUE(std::isnan(channels.source.x[7]));
  EXPECT_FALSE(std::isnan(channels.source.x[8]));
}

}  // namespace
