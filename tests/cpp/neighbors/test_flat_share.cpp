#include <gtest/gtest.h>

#include <cmath>

#include "neighbors/flat_share.h"
#include "support/clouds.h"

namespace {

TEST(FlatShare, PointsScatteredInSpaceHaveNextToNone) {
  for (const std::size_t n : {50u, 300u, 3000u})
    EXPECT_LT(emtr::flat_share(emtr_test::uniform_cloud(n, 3)), 0.1) << n;
}

TEST(FlatShare, ASurfaceIsFlatThoughItsNoiseIsMoreThanTheDistanceOfNeighbors) {
  emtr::Cloud cloud = emtr_test::uniform_cloud(10000, 4);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    cloud.z[i] = 0.2f * std::sin(2 * cloud.x[i]) + 0.02f * cloud.z[i];
  EXPECT_GT(emtr::flat_share(cloud), 0.5);
}

TEST(FlatShare, OfAFewPointsIsNone) {
  EXPECT_EQ(emtr::flat_share(emtr_test::uniform_cloud(12, 5)), 0);
}

}  // namespace
