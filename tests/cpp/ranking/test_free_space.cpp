#include <gtest/gtest.h>

#include "geometry/euler.h"
#include "ranking/free_space.h"
#include "ranking/surfaces.h"

namespace {

using emtr::FreeSpace;
using emtr::Rigid;
using emtr::Surface;
using emtr::Viewpoint;
using MaybeViewpoint = std::optional<Viewpoint>;

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

std::vector<std::uint8_t> none(const emtr::Cloud& cloud) {
  return std::vector<std::uint8_t>(cloud.size(), 0);
}

double violation(const MaybeViewpoint& source, const MaybeViewpoint& target, const Rigid& pose) {
  const Surface a = wall(), b = wall();
  FreeSpace::Scratch scratch;
  return FreeSpace(a, b, source, target, kernels())
      .violation({a.points, none(a.points)}, {b.points, none(b.points)}, pose, scratch);
}

const MaybeViewpoint kNone, kAbove = Viewpoint{{0, 0, 4}}, kBelow = Viewpoint{{0, 0, -4}};

TEST(FreeSpace, TheMeanOfBothShares) {
  EXPECT_EQ(violation(kAbove, kAbove, translation(0)), 0);
  // The source's points in front of the target: nearly all. The other way round they are behind.
  const double one = violation(kNone, kAbove, translation(0.5));
  EXPECT_GT(one, 0.35);  // being nearer, it reaches out of view
  EXPECT_LE(one, 0.5);
  EXPECT_EQ(violation(kAbove, kNone, translation(0.5)), 0);
  EXPECT_EQ(violation(kAbove, kAbove, translation(0.5)), one);
  EXPECT_NEAR(violation(kAbove, kAbove, translation(-0.5)), one, 0.05);
  // Sensors on opposite sides: both see the other in front, or neither does.
  EXPECT_GT(violation(kBelow, kAbove, translation(0.5)), 0.7);
  EXPECT_EQ(violation(kBelow, kAbove, translation(-0.5)), 0);
}

TEST(FreeSpace, CountsByTheTrustInTheViewpoint) {
  const double all = violation(kNone, kAbove, translation(0.5));
  Viewpoint half = *kAbove;
  half.trust = 0.5;
  EXPECT_EQ(violation(kNone, half, translation(0.5)), all / 2);
  half.trust = 0;
  EXPECT_EQ(violation(kNone, half, translation(0.5)), 0);
}

TEST(FreeSpace, OfAPartOfThePointsTheShareIsThatOfThePart) {
  const Surface a = wall(), b = wall();
  emtr::Cloud some;  // of the source: two points near the middle
  some.x = {0, 0.04f};
  some.y = some.z = {0, 0};
  FreeSpace::Scratch scratch;
  const FreeSpace both(a, b, kAbove, kAbove, kernels());
  const std::vector<std::uint8_t> no = none(some), first = {1, 0}, of_target = none(b.points);
  EXPECT_EQ(both.violation({some, no}, {b.points, of_target}, translation(0.5), scratch), 0.5);
  // What lies on the other surface contradicts nothing.
  EXPECT_EQ(both.violation({some, first}, {b.points, of_target}, translation(0.5), scratch), 0.25);
}

TEST(FreeSpace, NoViewpointsNoViolation) {
  EXPECT_EQ(violation(kNone, kNone, translation(0.5)), 0);
}

TEST(FreeSpace, DoesNotDependOnACommonMotion) {
  const double particle[6] = {1, 0.5, -2, 0.2, -0.1, 0.3};
  const Rigid M = emtr::decode(particle);
  const Surface a = emtr_test::lumpy_ball(4000, 1, 0.04, 0, 0),
                b = emtr_test::lumpy_ball(4000, 2, 0.04, 0, 0);
  const auto at = [&](const emtr_test::Vector& v) { return Viewpoint{{v[0], v[1], v[2]}}; };
  FreeSpace::Scratch scratch;
  const auto found = [&](const Surface& p, const Surface& q, const Viewpoint& of_p,
                         const Viewpoint& of_q, const Rigid& pose) {
    return FreeSpace(p, q, of_p, of_q, kernels())
        .violation({p.points, none(p.points)}, {q.points, none(q.points)}, pose, scratch);
  };
  const double here = found(a, b, at({0, 0, 3}), at({1, 0, 3}), translation(0.3));
  const double there =
      found(emtr_test::moved(a, M), emtr_test::moved(b, M), at(emtr_test::carry(M, {0, 0, 3})),
            at(emtr_test::carry(M, {1, 0, 3})),
            emtr_test::compose(M, emtr_test::compose(translation(0.3), M.inverse())));
  EXPECT_GT(here, 0.1);
  EXPECT_NEAR(here, there, 0.03);  // the bins lie otherwise
}

}  // namespace
