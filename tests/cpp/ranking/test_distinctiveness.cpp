#include <gtest/gtest.h>

#include <limits>

#include "geometry/euler.h"
#include "ranking/distinctiveness.h"
#include "ranking/surfaces.h"

namespace {

using emtr::distinctiveness;
using emtr::Surface;

/// 90 points of a floor and 10 of a wall.
Surface floor_and_wall() {
  Surface out;
  out.leaf = 0.1;
  for (int i = 0; i < 90; ++i) emtr_test::push(out, {0.1 * i, 0, 0}, {0, 0, i % 2 ? 1.0 : -1.0});
  for (int i = 0; i < 10; ++i) emtr_test::push(out, {0.1 * i, 1, 0}, {0, 1, 0});
  return out;
}

TEST(Distinctiveness, IsTheFormula) {
  const std::vector<float> weights = distinctiveness(floor_and_wall());
  ASSERT_EQ(weights.size(), 100u);
  EXPECT_NEAR(weights[0], std::pow(0.92, -1.5), 1e-4);  // whatever the sign of the normal
  EXPECT_NEAR(weights[1], std::pow(0.92, -1.5), 1e-4);
  EXPECT_NEAR(weights[95], std::pow(0.12, -1.5), 1e-3);
}

TEST(Distinctiveness, IsNoneWithoutANormal) {
  Surface some = floor_and_wall();
  some.normals.x[3] = some.normals.y[3] = some.normals.z[3] =
      std::numeric_limits<float>::quiet_NaN();
  const std::vector<float> weights = distinctiveness(some);
  EXPECT_EQ(weights[3], 0);
  EXPECT_GT(weights[4], 0);
}

TEST(Distinctiveness, IsTheSameHoweverTheSurfaceLies) {
  const Surface ball = emtr_test::lumpy_ball(3000, 1, 0.05);
  const double particle[6] = {1, 0.3, 2, 0.2, 0, 0.1};
  const std::vector<float> here = distinctiveness(ball),
                           there = distinctiveness(emtr_test::moved(ball, emtr::decode(particle)));
  for (std::size_t i = 0; i < here.size(); ++i) EXPECT_NEAR(there[i], here[i], 0.1f * here[i]);
}

TEST(Distinctiveness, TheLeastIsTheFirstOfThoseAboveZero) {
  EXPECT_EQ(emtr::least_distinctive({0, 3, 0, 2, 5, 2}), 3u);
  EXPECT_EQ(emtr::least_distinctive({1, 3}), 0u);
  EXPECT_EQ(emtr::least_distinctive({0, 0}), 0u);  // there is none
  EXPECT_EQ(emtr::least_distinctive({}), 0u);
}

}  // namespace
