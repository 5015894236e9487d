#include <gtest/gtest.h>

#include <cmath>

#include "util/portable_log.h"

namespace {

TEST(PortableLog, IsTheLogarithmToRounding) {
  for (double x = 1e-12; x < 1e12; x *= 1.37)
    EXPECT_NEAR(emtr::portable_log10(x), std::log10(x), 1e-14 * (1 + std::abs(std::log10(x))));
  EXPECT_EQ(emtr::portable_log10(1), 0);
}

}  // namespace
