#include <gtest/gtest.h>

#include "candidates/modes.h"
#include "refinement/shapes.h"

namespace {

using emtr::kCopy;
using emtr::kMode;
using emtr::within;
using emtr_test::motion;

TEST(Modes, ArePartedByTheAngle) {
  const emtr::Rigid a = motion({0, 0, 120}, {0.1, 0.2, 0.3});
  EXPECT_TRUE(within(a, a, {0, 0}));
  EXPECT_TRUE(within(a, motion({0, 0, 129.9}, {0.1, 0.2, 0.3}), kMode));
  EXPECT_FALSE(within(a, motion({0, 0, 130.1}, {0.1, 0.2, 0.3}), kMode));
  EXPECT_TRUE(within(a, motion({0, 0, 117.1}, {0.1, 0.2, 0.3}), kCopy));
  EXPECT_FALSE(within(a, motion({0, 0, 116.9}, {0.1, 0.2, 0.3}), kCopy));
}

TEST(Modes, ArePartedByTheOffset) {
  const emtr::Rigid a = motion({10, 20, 30}, {0.1, 0.2, 0.3});
  EXPECT_TRUE(within(a, motion({10, 20, 30}, {0.1, 0.349, 0.3}), kMode));
  EXPECT_FALSE(within(a, motion({10, 20, 30}, {0.1, 0.351, 0.3}), kMode));
  // As long as the straight way, not as the longest of its coordinates.
  EXPECT_FALSE(within(a, motion({10, 20, 30}, {0.2, 0.3, 0.4}), kMode));
  EXPECT_TRUE(within(a, motion({10, 20, 30}, {0.071, 0.2, 0.3}), kCopy));
  EXPECT_FALSE(within(a, motion({10, 20, 30}, {0.069, 0.2, 0.3}), kCopy));
}

TEST(Modes, HalfATurnIsFarWhicheverWayItGoes) {
  const emtr::Rigid a = motion({0, 179, 0}, {0, 0, 0}), b = motion({0, -179, 0}, {0, 0, 0});
  EXPECT_TRUE(within(a, b, kCopy));  // two degrees
  EXPECT_FALSE(within(a, emtr::Rigid{}, kMode));
}

TEST(Modes, NearnessGoesBothWaysAndACopyIsOfTheSameMode) {
  emtr_test::Draw draw(5);
  int copies = 0, modes = 0;
  for (int i = 0; i < 300; ++i) {
    const auto pose = [&] {
      return motion(draw.uniform(0, 8) * draw.direction(), draw.uniform(0, 0.1) * draw.direction());
    };
    const emtr::Rigid a = pose(), b = pose();
    EXPECT_EQ(within(a, b, kMode), within(b, a, kMode));
    EXPECT_EQ(within(a, b, kCopy), within(b, a, kCopy));
    if (within(a, b, kCopy)) {
      EXPECT_TRUE(within(a, b, kMode));
    }
    copies += within(a, b, kCopy);
    modes += within(a, b, kMode);
  }
  EXPECT_GT(copies, 0);
  EXPECT_GT(modes, copies);
  EXPECT_LT(modes, 300);
}

}  // namespace
