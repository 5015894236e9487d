#include <gtest/gtest.h>

#include <cmath>

#include "tasks/m_estimator.h"

namespace {

TEST(MEstimator, IsTukeysBiweight) {
  const double c = 0.05;
  for (double r = 0; r <= c; r += c / 64) {
    const double expected = 1 - std::pow(1 - (r / c) * (r / c), 3);
    const float squared = static_cast<float>(r * r);
    EXPECT_NEAR(emtr::rho(squared, static_cast<float>(1 / (c * c))), expected, 1e-6);
  }
}

TEST(MEstimator, RisesFromZeroToOneAtTheScale) {
  const float inverse = 1 / (0.3f * 0.3f);
  EXPECT_EQ(emtr::rho(0, inverse), 0);
  EXPECT_NEAR(emtr::rho(0.3f * 0.3f, inverse), 1, 1e-6);
  float last = 0;
  for (float squared = 0; squared < 0.09f; squared += 0.001f) {
    EXPECT_GE(emtr::rho(squared, inverse), last);
    last = emtr::rho(squared, inverse);
  }
}

TEST(MEstimator, WeightVanishesBeyondTheScale) {
  EXPECT_EQ(emtr::tukey_weight(0, 0.25), 1);
  EXPECT_DOUBLE_EQ(emtr::tukey_weight(0.125, 0.25), 0.25);
  EXPECT_EQ(emtr::tukey_weight(0.26, 0.25), 0);
}

}  // namespace
