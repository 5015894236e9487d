#include <gtest/gtest.h>

#include <cmath>

#include "colors/color_gradients.h"
#include "colors/painted.h"

namespace {

constexpr bool kAll[3] = {true, true, true}, kFirst[3] = {true, false, false};

/// A tilted plane whose first channel is 2 u - v of its own coordinates.
struct Ramp {
  emtr::Surface surface;
  emtr::Cloud colors;
  Eigen::Vector3d gradient;

  Ramp() {
    const emtr::Rigid tilt = emtr_test::motion({20, -35, 10}, {0, 0, 0.2});
    emtr_test::Draw draw(3);
    for (int i = 0; i < 4000; ++i) {
      const double u = draw.uniform(-0.5, 0.5), v = draw.uniform(-0.5, 0.5);
      const Eigen::Vector3d p = tilt * Eigen::Vector3d(u, v, 0);
      emtr_test::push(surface.points, static_cast<float>(p.x()), static_cast<float>(p.y()),
                      static_cast<float>(p.z()));
      const Eigen::Vector3f n = tilt.rotate({0, 0, 1}).cast<float>();
      emtr_test::push(surface.normals, n.x(), n.y(), n.z());
      emtr_test::push(colors, static_cast<float>(2 * u - v), 0.5f, 0.0f);
    }
    surface.leaf = 0.02;
    gradient = tilt.rotate({2, -1, 0});
  }
};

TEST(ColorField, OfARampHasItsGradient) {
  const Ramp ramp;
  const emtr::ColorField field = emtr::fit_color_field(ramp.surface, ramp.colors, kAll, 0.08, true);
  for (std::size_t i = 0; i < ramp.colors.size(); ++i) {
    const auto& d = field.gradients[0][i];
    EXPECT_NEAR((Eigen::Vector3d(d[0], d[1], d[2]) - ramp.gradient).norm(), 0, 1e-3) << i;
    EXPECT_NEAR(field.values.x[i], ramp.colors.x[i], 1e-4) << i;
    EXPECT_NEAR(field.gradients[1][i][0], 0, 1e-4);
    EXPECT_NEAR(field.values.y[i], 0.5, 1e-5);
  }
}

TEST(ColorField, HasGradientsOfUsedChannelsOnly) {
  const Ramp ramp;
  const emtr::ColorField one = emtr::fit_color_field(ramp.surface, ramp.colors, kFirst, 0.08, true),
                         none = emtr::fit_color_field(ramp.surface, ramp.colors, kAll, 0.08, false);
  EXPECT_FALSE(one.gradients[0].empty());
  EXPECT_TRUE(one.gradients[1].empty());
  EXPECT_TRUE(none.gradients[0].empty());
}

TEST(ColorField, OfALonelyPointIsItsColor) {
  Ramp ramp;
  emtr_test::push(ramp.surface.points, 5, 5, 5);
  emtr_test::push(ramp.surface.normals, 0, 0, 1);
  emtr_test::push(ramp.colors, 0.25f, 0, 0);
  const emtr::ColorField field = emtr::fit_color_field(ramp.surface, ramp.colors, kAll, 0.08, true);
  EXPECT_FLOAT_EQ(field.values.x.back(), 0.25f);
  for (const float v : field.gradients[0].back()) EXPECT_EQ(v, 0);
}

TEST(ColorField, NeedsANormal) {
  Ramp ramp;
  ramp.surface.normals.x[11] = std::nanf("");
  const emtr::ColorField field = emtr::fit_color_field(ramp.surface, ramp.colors, kAll, 0.08, true);
  EXPECT_TRUE(std::isnan(field.values.x[11]));
}

}  // namespace
