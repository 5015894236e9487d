#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "geometry/ladder.h"

using emtr::Ladder;

namespace {

TEST(Ladder, HasEightRungsAnOctave) {
  EXPECT_EQ(Ladder::rung(0), 1);
  EXPECT_EQ(Ladder::rung(8), 2);
  EXPECT_EQ(Ladder::rung(-8), 0.5);
  EXPECT_EQ(Ladder::rung(-16), 0.25);
  for (int i = -40; i < 40; ++i)
    EXPECT_NEAR(Ladder::rung(i + 1) / Ladder::rung(i), std::pow(2, 0.125), 1e-15) << i;
}

TEST(Ladder, FindsTheNextRungAboveAndTheNearest) {
  for (double length = 1e-9; length < 1e9; length *= 1.013) {
    const double above = Ladder::above(length), nearest = Ladder::nearest(length);
    EXPECT_GE(above, length);
    EXPECT_LT(above / length, Ladder::rung(1) * (1 + 1e-15));
    EXPECT_LT(std::abs(std::log(nearest / length)), std::log(Ladder::rung(1)) / 2 * (1 + 1e-9));
  }
}

TEST(Ladder, ARungStandsForItself) {
  for (int i = -100; i < 100; ++i) {
    EXPECT_EQ(Ladder::above(Ladder::rung(i)), Ladder::rung(i));
    EXPECT_EQ(Ladder::nearest(Ladder::rung(i)), Ladder::rung(i));
    const double more = std::nextafter(Ladder::rung(i), std::numeric_limits<double>::max());
    EXPECT_EQ(Ladder::above(more), Ladder::rung(i + 1));
  }
}

TEST(Ladder, ReachesFarUpAndDown) {
  for (const double length : {1e-150, 1e150}) {
    EXPECT_GE(Ladder::above(length), length);
    EXPECT_LT(Ladder::above(length), 1.1 * length);
  }
}

}  // namespace
