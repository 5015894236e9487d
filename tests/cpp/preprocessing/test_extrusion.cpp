#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "preprocessing/extrusion.h"

namespace {

/// An L of two walls in the plane through the origin across (0, u, v), of unit length.
std::vector<float> outline(float u, float v, float off = 0) {
  std::vector<float> packed;
  for (int i = 0; i < 100; ++i) {
    const float a = i < 60 ? 0.05f * static_cast<float>(i) : 0,
                b = i < 60 ? 0 : 0.05f * static_cast<float>(i - 60), up = i == 7 ? off : 0;
    packed.insert(packed.end(), {a, b * v + up * u, -b * u + up * v});
  }
  return packed;
}

emtr::NormalizedPair normalized(const std::vector<float>& source, const std::vector<float>& target,
                                const std::vector<float>& normals = {}) {
  const auto view = [&](const std::vector<float>& packed) {
    emtr_cloud cloud{packed.data(), packed.size() / 3, 0, EMTR_FLOAT32};
    if (!normals.empty()) cloud.normals = normals.data();
    return cloud;
  };
  return emtr::normalize(view(source), view(target), 1);
}

emtr::Settings along(double x, double y, double z, double tilt = 0) {
  emtr::Settings settings = emtr::preset("default");
  settings.has_axis = 1;
  const double axis[3] = {x, y, z};
  std::copy_n(axis, 3, settings.axis);
  settings.axis_tilt = tilt;
  return settings;
}

TEST(Extrusion, MakesWallsOfOutlinesAcrossTheAxis) {
  auto pair = normalized(outline(0.6f, 0.8f), outline(0.6f, 0.8f));
  const emtr::Cloud flat = pair.source;
  emtr::extrude_flat_pair(pair, along(0, 3, 4));
  EXPECT_TRUE(pair.extruded);
  ASSERT_EQ(pair.source.size(), 32 * flat.size());
  ASSERT_EQ(pair.target.size(), 32 * flat.size());
  double lowest = 0, highest = 0;
  for (std::size_t i = 0; i < pair.source.size(); ++i) {
    const std::size_t from = i % flat.size();
    const double y = double{pair.source.y[i]} - double{flat.y[from]},
                 z = double{pair.source.z[i]} - double{flat.z[from]};
    EXPECT_EQ(pair.source.x[i], flat.x[from]);
    EXPECT_NEAR(0.8 * y - 0.6 * z, 0, 1e-6);
    lowest = std::min(lowest, 0.6 * y + 0.8 * z);
    highest = std::max(highest, 0.6 * y + 0.8 * z);
  }
  EXPECT_NEAR(lowest, -0.2, 1e-6);
  EXPECT_NEAR(highest, 0.2, 1e-6);
}

TEST(Extrusion, ChangesNothingElse) {
  const auto unchanged = [](emtr::NormalizedPair pair, const emtr::Settings& settings) {
    const std::vector<float> x = pair.source.x;
    emtr::extrude_flat_pair(pair, settings);
    return !pair.extruded && pair.source.x == x;
  };
  const std::vector<float> flat = outline(0, 1), bent = outline(0, 1, 0.1f);
  EXPECT_FALSE(unchanged(normalized(flat, flat), along(0, 0, -2)));
  EXPECT_TRUE(unchanged(normalized(flat, flat), emtr::preset("default")));
  EXPECT_TRUE(unchanged(normalized(flat, flat), along(0, 1, 1)));
  EXPECT_TRUE(unchanged(normalized(flat, flat), along(0, 0, 1, 2)));
  EXPECT_TRUE(unchanged(normalized(flat, bent), along(0, 0, 1)));
  EXPECT_TRUE(unchanged(normalized(bent, flat), along(0, 0, 1)));
  EXPECT_TRUE(unchanged(normalized(flat, flat, std::vector<float>(300, 1)), along(0, 0, 1)));
}

TEST(Extrusion, KeepsALargeOutlineSmall) {
  std::vector<float> packed;
  for (int i = 0; i < 150000; ++i) {
    const float a = 0.0001f * static_cast<float>(i);
    packed.insert(packed.end(), {a * std::cos(a), a * std::sin(a), 5});
  }
  auto pair = normalized(packed, packed);
  emtr::extrude_flat_pair(pair, along(0, 0, 1));
  EXPECT_TRUE(pair.extruded);
  EXPECT_LE(pair.source.size(), 1u << 20);
}

}  // namespace
