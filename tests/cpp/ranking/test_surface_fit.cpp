#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <thread>

#include "geometry/euler.h"
#include "ranking/distinctiveness.h"
#include "ranking/surface_fit.h"
#include "ranking/surfaces.h"

namespace {

using emtr::Rigid;
using emtr::Surface;
using emtr::SurfaceFit;
using emtr::SurfaceFitValue;
using emtr_test::carry;
using emtr_test::lumpy_ball;
using emtr_test::point;
using emtr_test::Vector;

const emtr::Kernels& kernels() { return emtr::select_kernels(); }

Rigid pose(double a, double b, double c, double x, double y, double z) {
  const double particle[6] = {a, b, c, x, y, z};
  return emtr::decode(particle);
}

SurfaceFitValue fit(const Surface& source, const Surface& target, const Rigid& T) {
  SurfaceFit::Scratch scratch;
  return SurfaceFit(source, target, kernels()).evaluate(T, scratch);
}

struct Oracle {
  double all = 0, near = 0;  // sums of weights
  double weight = 0, same = 0, sign = 0, squared = 0, inliers = 0;
};

/// Straight from the formula, in double, all against all.
Oracle oracle(const Surface& from, const Surface& to, const Rigid& T, std::size_t step) {
  Oracle sum;
  const double l = to.leaf;
  const std::vector<float> weights = emtr::distinctiveness(from);
  for (std::size_t i = 0; i < from.points.size(); i += step) {
    const double telling = weights[i];
    sum.all += telling;
    const Vector y = carry(T, point(from.points, i)), n = carry(T, point(from.normals, i), true);
    double nearest = HUGE_VAL, e = 0, dot = 0;
    for (std::size_t k = 0; k < to.points.size(); ++k) {
      const Vector q = point(to.points, k), d{y[0] - q[0], y[1] - q[1], y[2] - q[2]};
      if (emtr_test::dot(d, d) >= nearest) continue;
      nearest = emtr_test::dot(d, d);
      e = emtr_test::dot(point(to.normals, k), d);
      dot = emtr_test::dot(point(to.normals, k), n);
    }
    if (std::sqrt(nearest) >= 1.5 * l) continue;
    sum.near += telling;
    if (!(std::abs(dot) > 0.7) || !(std::abs(e) < 0.3 * l)) continue;
    const double weight = telling * std::pow(1 - std::pow(e / (0.3 * l), 2), 2);
    sum.weight += weight;
    if (dot > 0) sum.same += weight;
    sum.sign += dot;
    sum.squared += e * e / (l * l);
    sum.inliers += 1;
  }
  return sum;
}

void expect_oracle(const SurfaceFitValue& got, const Surface& source, const Surface& target,
                   const Rigid& T, std::size_t step) {
  const Oracle a = oracle(source, target, T, step), b = oracle(target, source, T.inverse(), step);
  const auto count = [step](const Surface& s) {
    return static_cast<double>((s.points.size() + step - 1) / step);
  };
  const double n = count(source), m = count(target), inliers = a.inliers + b.inliers;
  ASSERT_GT(inliers, 20);  // of something
  EXPECT_NEAR(got.score, (a.weight / a.all + b.weight / b.all) / 2, 1e-5);
  EXPECT_NEAR(got.near, (a.near / a.all + b.near / b.all) / 2, 1e-5);
  EXPECT_NEAR(got.same_side, (a.same / a.all + b.same / b.all) / 2, 1e-5);
  EXPECT_LT(got.same_side, got.score);
  EXPECT_EQ(got.inliers_source, a.inliers / n);
  EXPECT_EQ(got.inliers_target, b.inliers / m);
  EXPECT_NEAR(got.sign, (a.sign + b.sign) / inliers, 1e-5);
  EXPECT_NEAR(got.rms, std::sqrt((a.squared + b.squared) / inliers), 1e-5);
}

TEST(SurfaceFit, IsTheFormula) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    const Surface source = lumpy_ball(700, 2 * seed, 0.08, 0.02);
    Surface target = lumpy_ball(900, 2 * seed + 1, 0.08, 0.02);
    const float none = std::numeric_limits<float>::quiet_NaN();
    for (std::size_t i = seed; i < 900; i += 17)
      target.normals.x[i] = target.normals.y[i] = target.normals.z[i] = none;
    for (std::size_t i = seed; i < 900; i += 5) {  // normals of either sign
      target.normals.x[i] = -target.normals.x[i];
      target.normals.y[i] = -target.normals.y[i];
      target.normals.z[i] = -target.normals.z[i];
    }
    SurfaceFit fit(source, target, kernels());
    fit.add_subset(3);
    SurfaceFit::Scratch scratch;
    for (const Rigid& T :
         {Rigid{}, pose(0.1, -0.05, 0.2, 0.03, -0.02, 0.05), pose(2, 1, -1, 0.1, 0.2, 0)}) {
      expect_oracle(fit.evaluate(T, scratch), source, target, T, 1);
      expect_oracle(fit.evaluate(T, 3, scratch), source, target, T, 3);
    }
  }
}

TEST(SurfaceFit, KnownValuesOfAPlaneMovedAlongItsNormal) {
  Surface plane, other;
  plane.leaf = other.leaf = 0.1;
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j) {
      emtr_test::push(plane, {0.1 * i, 0.1 * j, 0}, {0, 0, 1});
      emtr_test::push(other, {0.1 * i, 0.1 * j, 0}, {0, 0, -1});
    }
  const SurfaceFitValue on = fit(plane, plane, Rigid{});
  EXPECT_NEAR(on.score, 1, 1e-6);
  EXPECT_EQ(on.inliers_source, 1);
  EXPECT_EQ(on.inliers_target, 1);
  EXPECT_EQ(on.sign, 1);
  EXPECT_EQ(on.rms, 0);
  const SurfaceFitValue off = fit(plane, other, pose(0, 0, 0, 0, 0, 0.015));
  EXPECT_NEAR(off.score, 0.5625, 1e-5);  // (1 - 0.5^2)^2
  EXPECT_NEAR(off.rms, 0.15, 1e-6);
  EXPECT_EQ(off.sign, -1);
  EXPECT_EQ(off.same_side, 0);
  EXPECT_EQ(fit(plane, other, pose(0, 0, 0, 0, 0, 0.031)).score, 0);
  EXPECT_EQ(fit(plane, plane, pose(0, 0, 0, 5, 0, 0)).score, 0);
  EXPECT_EQ(fit(plane, plane, pose(0, 0, 0, 5, 0, 0)).sign, 0);
  // Half of each lies on the other (one column more is within reach of its neighbors).
  EXPECT_NEAR(fit(plane, plane, pose(0, 0, 0, 0.5, 0, 0)).score, 0.6, 1e-6);
  // A wall through the plane: near, but facing another way.
  EXPECT_EQ(fit(plane, plane, pose(0, 1.5707963267948966, 0, 0, 0, 0)).score, 0);
}

TEST(SurfaceFit, APoleOutweighsTheGround) {
  // A ground of 31 x 31 points with a thin pole of 20, which stands in the middle or aside.
  const auto scene = [](double at) {
    Surface out;
    out.leaf = 0.05;
    for (int i = -15; i <= 15; ++i)
      for (int j = -15; j <= 15; ++j) emtr_test::push(out, {0.05 * i, 0.05 * j, 0}, {0, 0, 1});
    for (int i = 1; i <= 20; ++i) emtr_test::push(out, {at, 0, 0.05 * i}, {1, 0, 0});
    return out;
  };
  // The ground lies on itself with the pole missed; the pole on itself while half of the ground has
  // nothing below it.
  const double ground = fit(scene(0), scene(0.3), Rigid{}).score,
               pole = fit(scene(0), scene(0.3), pose(0, 0, 0, 0.3, 0, 0)).score;
  EXPECT_LT(ground, 0.5 * pole);
}

TEST(SurfaceFit, MarksItsInliers) {
  const Surface source = lumpy_ball(700, 1, 0.08, 0.02), target = lumpy_ball(900, 2, 0.08, 0.02);
  SurfaceFit::Scratch scratch;
  const SurfaceFitValue value = SurfaceFit(source, target, kernels()).evaluate(Rigid{}, scratch);
  const auto share = [&](int side) {
    const auto& marks = scratch.inlier[side];
    return static_cast<double>(std::count(marks.begin(), marks.end(), 1)) /
           static_cast<double>(marks.size());
  };
  EXPECT_EQ(scratch.inlier[0].size(), 700u);
  EXPECT_EQ(share(0), value.inliers_source);
  EXPECT_EQ(share(1), value.inliers_target);
  EXPECT_GT(share(0), 0.1);
}

TEST(SurfaceFit, DoesNotDependOnACommonMotion) {
  const Surface source = lumpy_ball(1500, 1, 0.06, 0.01), target = lumpy_ball(1500, 2, 0.06, 0.01);
  const Rigid T = pose(0.05, 0.02, -0.04, 0.01, 0.02, 0), M = pose(1, 0.5, -2, 0.2, -0.1, 0.3);
  const SurfaceFitValue here = fit(source, target, T);
  const SurfaceFitValue there = fit(emtr_test::moved(source, M), emtr_test::moved(target, M),
                                    emtr_test::compose(M, emtr_test::compose(T, M.inverse())));
  ASSERT_GT(here.score, 0.1);
  EXPECT_NEAR(here.score, there.score, 2e-3);  // a gate may go the other way at its border
  EXPECT_NEAR(here.sign, there.sign, 2e-3);
  EXPECT_NEAR(here.rms, there.rms, 2e-3);
}

TEST(SurfaceFit, PrefersTheTruth) {
  const Surface source = lumpy_ball(3000, 3, 0.04), target = lumpy_ball(3000, 4, 0.04);
  const double truth = fit(source, target, Rigid{}).score;
  EXPECT_GT(truth, 0.85);
  for (const Rigid& wrong : {pose(1, 0, 0, 0, 0, 0), pose(0, 1, 0, 0, 0, 0),
                             pose(3, 0.3, 2, 0, 0, 0), pose(0, 0, 0, 0.05, 0, 0)})
    EXPECT_LT(fit(source, target, wrong).score, 0.5 * truth);
}

bool same(const SurfaceFitValue& a, const SurfaceFitValue& b) {
  return a.score == b.score && a.same_side == b.same_side && a.sign == b.sign &&
         a.inliers_source == b.inliers_source && a.inliers_target == b.inliers_target &&
         a.rms == b.rms && a.near == b.near;
}

TEST(SurfaceFit, SameBitsForEveryKernelThreadAndScratch) {
  const Surface source = lumpy_ball(1003, 5, 0.06, 0.01), target = lumpy_ball(901, 6, 0.06, 0.01);
  std::vector<Rigid> poses;
  for (int i = 0; i < 40; ++i) poses.push_back(pose(0.01 * i, 0.02 * i, 0.1, 0.001 * i, 0, 0.01));
  std::vector<SurfaceFitValue> first;
  for (const emtr::Kernels* k : emtr_test::kernels_here()) {
    SurfaceFit fit(source, target, *k);
    fit.add_subset(4);
    for (std::size_t threads : {1u, 3u}) {
      std::vector<SurfaceFitValue> got(poses.size());
      std::vector<std::thread> team;
      for (std::size_t t = 0; t < threads; ++t)
        team.emplace_back([&, t] {
          SurfaceFit::Scratch scratch;
          for (std::size_t i = t; i < poses.size(); i += threads)
            got[i] = fit.evaluate(poses[i], i % 2 ? 4 : 1, scratch);
        });
      for (std::thread& thread : team) thread.join();
      if (first.empty()) first = got;
      for (std::size_t i = 0; i < poses.size(); ++i) EXPECT_TRUE(same(got[i], first[i])) << k->name;
    }
  }
}

TEST(SurfaceFit, RefusesWhatItCannotUse) {
  const Surface good = lumpy_ball(50, 7, 0.1);
  Surface bad = good;
  bad.leaf = 0.2;
  EXPECT_THROW(SurfaceFit(good, bad, kernels()), std::invalid_argument);
  bad = good;
  bad.normals.resize(10);
  EXPECT_THROW(SurfaceFit(good, bad, kernels()), std::invalid_argument);
  EXPECT_THROW(SurfaceFit(Surface{}, Surface{}, kernels()), std::invalid_argument);
  SurfaceFit::Scratch scratch;
  EXPECT_THROW(SurfaceFit(good, good, kernels()).evaluate(Rigid{}, 5, scratch),
               std::invalid_argument);
  EXPECT_THROW(SurfaceFit(good, good, kernels()).add_subset(0), std::invalid_argument);
}

}  // namespace
