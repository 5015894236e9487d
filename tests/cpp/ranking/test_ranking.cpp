#include <gtest/gtest.h>

#include "geometry/euler.h"
#include "ranking/ranking.h"
#include "ranking/surfaces.h"

namespace {

using emtr::Ranking;
using emtr::Rigid;
using emtr::Surface;
using emtr::Viewpoint;

const emtr::Kernels& kernels() { return emtr::select_kernels(); }

/// Two planes at right angles, as seen into their corner from (0, 4, 4). Planes lie on planes in
/// many ways.
Surface corner(double phase) {
  Surface out;
  out.leaf = 0.04;
  for (int i = 0; i < 35; ++i)
    for (int j = 0; j < 20; ++j) {
      const double x = 0.04 * (i - 17 + phase), y = 0.04 * (j + phase);
      emtr_test::push(out, {x, y, 0}, {0, 0, i % 2 ? 1.0 : -1.0});
      emtr_test::push(out, {x, 0, y}, {0, j % 2 ? 1.0 : -1.0, 0});
    }
  return out;
}

const std::optional<Viewpoint> kAt = Viewpoint{{0, 4, 4}}, kNone;

/// The formula, from the fit that counts.
double score(const Ranking::Value& value, double fit) {
  return fit - 0.1 * (value.fit.near - fit) - value.violation;
}

TEST(Ranking, IsTheFitLessTheMissesAndTheViolation) {
  Ranking ranking(corner(0), corner(0.3), kAt, kAt, kernels());
  Ranking::Scratch scratch;
  // On the right plane, and turned over: the other plane then stands before the floor.
  const double particle[6] = {0, 0, 1.5707963267948966, 0, 0.4, 0};
  for (const Rigid& T : {Rigid{}, emtr::decode(particle)}) {
    const Ranking::Value value = ranking.evaluate(T, scratch);
    EXPECT_EQ(value.score, score(value, value.fit.same_side));
  }
  const Ranking::Value right = ranking.evaluate(Rigid{}, scratch),
                       wrong = ranking.evaluate(emtr::decode(particle), scratch);
  EXPECT_GT(right.fit.score, 0.9);
  EXPECT_EQ(right.violation, 0);
  EXPECT_GT(right.fit.sign, 0.95);  // whatever the signs of the normals that were given
  EXPECT_GT(wrong.violation, 0.05);
}

TEST(Ranking, TheQuickScoreIsTheScoreOfAPart) {
  Ranking ranking(corner(0), corner(0.3), kAt, kAt, kernels());
  ranking.fit().add_subset(8);
  Ranking::Scratch scratch;
  const double particle[6] = {0, 0, 1.5707963267948966, 0, 0.4, 0};
  for (const Rigid& T : {Rigid{}, emtr::decode(particle)}) {
    const Ranking::Value all = ranking.evaluate(T, scratch), some = ranking.evaluate(T, scratch, 8);
    EXPECT_EQ(some.fit.score, ranking.fit().evaluate(T, 8, scratch.fit).score);
    EXPECT_EQ(some.score, score(some, some.fit.same_side));
    EXPECT_NEAR(some.violation, all.violation, 0.1);
  }
  EXPECT_LT(ranking.evaluate(emtr::decode(particle), scratch, 8).score, 0.2);
}

TEST(Ranking, BackOnFrontIsNoFitWhereBothSensorsAreKnown) {
  // The floor slid under itself, rotated by 180 degrees about x: only its back can lie on the
  // front.
  const double particle[6] = {0, 0, 3.141592653589793, 0, 0.7, 0};
  const Rigid upside_down = emtr::decode(particle);
  Viewpoint guess = *kAt;
  guess.given = false;
  Ranking::Scratch scratch;
  Ranking given(corner(0), corner(0), kAt, kAt, kernels());
  const Ranking::Value known = given.evaluate(upside_down, scratch);
  EXPECT_GT(known.fit.score, 0.2);
  EXPECT_EQ(known.fit.same_side, 0);
  EXPECT_LE(known.score, 0);
  Ranking estimated(corner(0), corner(0), kAt, guess, kernels());
  const Ranking::Value open = estimated.evaluate(upside_down, scratch);
  EXPECT_EQ(open.score, score(open, open.fit.score));
}

TEST(Ranking, WithoutViewpointsNothingIsViolated) {
  Ranking ranking(corner(0), corner(0.3), kNone, kNone, kernels());
  Ranking::Scratch scratch;
  const double particle[6] = {0, 0, 1.5707963267948966, 0, 0.4, 0};
  const Ranking::Value value = ranking.evaluate(emtr::decode(particle), scratch);
  EXPECT_EQ(value.violation, 0);
  EXPECT_EQ(value.score, score(value, value.fit.score));
}

TEST(Ranking, CopiesASurfaceOnlyToOrientItsNormals) {
  const emtr::SharedSurface source = corner(0), target = corner(0.3);
  const Ranking shared(source, target, kNone, kNone, kernels());
  EXPECT_EQ(&shared.fit().points(0, 1), &source->points);
  EXPECT_EQ(&shared.fit().points(1, 1), &target->points);
  const Ranking oriented(source, target, kAt, kNone, kernels());
  EXPECT_NE(&oriented.fit().points(0, 1), &source->points);
  EXPECT_EQ(&oriented.fit().points(1, 1), &target->points);
}

TEST(Ranking, SameBitsForEveryKernel) {
  const double particle[6] = {0.1, 0, 0.2, 0, 0.1, 0};
  Ranking::Scratch scratch;
  std::vector<double> scores;
  for (const emtr::Kernels* k : emtr_test::kernels_here()) {
    Ranking ranking(emtr_test::lumpy_ball(3000, 1, 0.05, 0.01, 0.2),
                    emtr_test::lumpy_ball(3000, 2, 0.05, 0.01, 0), Viewpoint{{0, 0, 4}},
                    Viewpoint{{0, 1, 3}}, *k);
    scores.push_back(ranking.evaluate(emtr::decode(particle), scratch).score);
  }
  for (const double score : scores) EXPECT_EQ(score, scores[0]);
}

}  // namespace
