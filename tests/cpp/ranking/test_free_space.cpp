#include <gtest/gtest.h>

#include "geometry/euler.h"
#include "ranking/free_space.h"
#include "ranking/surfaces.h"

namespace {

using emtr::FreeSpace;
using emtr::Rigid;
using emtr::Surface;
using emtr::Viewpoints;

const emtr::Kernels& kernels() { return emtr::select_kernels(); }

/// z = 0, from -1 to 1 each way; normals to +z.
Surface wall() {
  Surface out;
  out.leaf = 0.04;
  for (int i = -25; i <= 25; ++i)
    for (int j = -25; j <= 25; ++j) emtr_test::push(out, {0.04 * i, 0.04 * j, 0}, {0, 0, 1});
  return out;
}

Rigid translation(double z) {
  Rigid out;
  out.t[2] = z;
  return out;
}

double violation(const Viewpoints& source, const Viewpoints& target, const Rigid& pose,
                 double sign) {
  const Surface a = wall(), b = wall();
  FreeSpace::Scratch scratch;
  return FreeSpace(a, b, source, target, kernels()).violation(pose, sign, scratch);
}

const Viewpoints kNone, kAbove{{{{0, 0, 4}}}, 1}, kBelow{{{{0, 0, -4}}}, 1},
    kEither{{{{0, 0, 4}}, {{0, 0, -4}}}, 1};

TEST(FreeSpace, TheMeanOfBothShares) {
  EXPECT_EQ(violation(kAbove, kAbove, translation(0), 1), 0);
  // The source's points in front of the target: nearly all. The other way round they are behind.
  const double one = violation(kNone, kAbove, translation(0.5), 1);
  EXPECT_GT(one, 0.35);  // being nearer, it reaches out of view
  EXPECT_LE(one, 0.5);
  EXPECT_EQ(violation(kAbove, kNone, translation(0.5), 1), 0);
  EXPECT_EQ(violation(kAbove, kAbove, translation(0.5), 1), one);
  EXPECT_NEAR(violation(kAbove, kAbove, translation(-0.5), 1), one, 0.05);
  // Sensors on opposite sides: both see the other in front, or neither does.
  EXPECT_GT(violation(kBelow, kAbove, translation(0.5), 1), 0.7);
  EXPECT_EQ(violation(kBelow, kAbove, translation(-0.5), 1), 0);
}

TEST(FreeSpace, OfAPartOfThePointsTheShareIsThatOfThePart) {
  const Surface a = wall(), b = wall();
  emtr::Cloud some;  // of the source: two points near the middle
  some.x = {0, 0.04f};
  some.y = some.z = {0, 0};
  FreeSpace::Scratch scratch;
  const FreeSpace both(a, b, kAbove, kAbove, kernels());
  EXPECT_EQ(both.violation(some, b.points, translation(0.5), 1, scratch), 0.5);
  EXPECT_EQ(both.violation(a.points, b.points, translation(0.5), 1, scratch),
            both.violation(translation(0.5), 1, scratch));
}

TEST(FreeSpace, NoViewpointsNoViolation) {
  EXPECT_EQ(violation(kNone, kNone, translation(0.5), 1), 0);
  EXPECT_EQ(violation(kNone, kNone, translation(0.5), -1), 0);
}

TEST(FreeSpace, OfEstimatesTheLeastAdmissibleOneCounts) {
  // One estimate alone says nothing of the side.
  EXPECT_EQ(violation(kNone, kEither, translation(0.5), 1), 0);
  EXPECT_EQ(violation(kNone, kEither, translation(-0.5), 1), 0);
  // Two: the same side (a half of all points is in front), or opposite ones (all, or nothing).
  EXPECT_GT(violation(kEither, kEither, translation(0.5), 1), 0.35);
  EXPECT_EQ(violation(kEither, kEither, translation(0.5), -1), 0);
  // Given and estimated.
  EXPECT_GT(violation(kAbove, kEither, translation(0.5), 1), 0.35);
  EXPECT_EQ(violation(kAbove, kEither, translation(0.5), -1), 0);
  EXPECT_GT(violation(kAbove, kEither, translation(-0.5), -1), 0.7);
}

TEST(FreeSpace, DoesNotDependOnACommonMotion) {
  const double particle[6] = {1, 0.5, -2, 0.2, -0.1, 0.3};
  const Rigid M = emtr::decode(particle);
  const Surface a = emtr_test::lumpy_ball(4000, 1, 0.04, 0, 0),
                b = emtr_test::lumpy_ball(4000, 2, 0.04, 0, 0);
  const auto at = [&](const emtr_test::Vector& v) { return Viewpoints{{{{v[0], v[1], v[2]}}}, 1}; };
  FreeSpace::Scratch scratch;
  const double here = FreeSpace(a, b, at({0, 0, 3}), at({1, 0, 3}), kernels())
                          .violation(translation(0.3), 1, scratch);
  const Surface c = emtr_test::moved(a, M), d = emtr_test::moved(b, M);
  const double there =
      FreeSpace(c, d, at(emtr_test::carry(M, {0, 0, 3})), at(emtr_test::carry(M, {1, 0, 3})),
                kernels())
          .violation(emtr_test::compose(M, emtr_test::compose(translation(0.3), M.inverse())), 1,
                     scratch);
  EXPECT_GT(here, 0.1);
  EXPECT_NEAR(here, there, 0.03);  // the bins lie otherwise
}

}  // namespace
