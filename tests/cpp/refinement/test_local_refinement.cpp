#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>

#include "preprocessing/normalization.h"
#include "priors/make_prior.h"
#include "ranking/surfaces.h"
#include "refinement/constrained_step.h"
#include "refinement/refiner.h"
#include "refinement/shapes.h"
#include "util/error.h"

namespace {

using emtr::LocalRefinement;
using emtr::LocalRefinementResult;
using emtr::LocalRefinementSettings;
using emtr::Rigid;
using emtr::Surface;
using emtr::Termination;
using emtr_test::degrees_between;
using emtr_test::motion;
using emtr_test::Refiner;
using emtr_test::translation_between;

struct Scans {
  emtr::NormalizedPair pair;
  Rigid truth;

  explicit Scans(std::uint64_t seed, std::size_t points) {
    const emtr_test::Pair made(seed, points);
    pair = emtr::normalize(made.source(), made.target(), 1);
    truth = pair.normalization.to_normalized(emtr::from_matrix(made.pose()));
  }
  Surface source(double leaf) const { return emtr::downsample_surface(pair.source, leaf); }
  Surface target(double leaf) const { return emtr::downsample_surface(pair.target, leaf); }

  /// The truth after a small motion on its left.
  Rigid off(const Eigen::Vector3d& degrees, const Eigen::Vector3d& translation) const {
    const Rigid by = motion(degrees, translation);
    Rigid out;
    const Eigen::Matrix3d& R = by.R;
    out.R = R * truth.R;
    out.t = R * truth.t + translation;
    return out;
  }
};

const Scans& scans() {
  static const Scans made(11, 30000);
  return made;
}

std::array<double, 16> bits(const LocalRefinementResult& refined) {
  std::array<double, 16> out;
  emtr::to_matrix(refined.pose, out.data());
  return out;
}

TEST(LocalRefinement, FindsThePoseFromWhatTheSearchLeaves) {
  const Refiner refiner(scans().source(0.015), scans().target(0.015), LocalRefinementSettings());
  const Rigid start = scans().off({0.6, -0.7, 0.4}, {0.006, 0.005, -0.006});
  const LocalRefinementResult out = refiner(start);
  EXPECT_EQ(out.end, Termination::Converged);
  EXPECT_LT(degrees_between(out.pose, scans().truth), 0.05);
  EXPECT_LT(translation_between(out.pose, scans().truth), 5e-4);
  EXPECT_GT(out.inlier_share_source, 0.4);
  EXPECT_GT(out.inlier_share_target, 0.4);
  EXPECT_GT(out.rmse, 0);
  EXPECT_LT(out.rmse, 0.015 / 4);
  double T[16];
  emtr::to_matrix(out.pose, T);
  const Eigen::Matrix3d& R = out.pose.R;
  EXPECT_LT((R * R.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-14);
}

TEST(LocalRefinement, CoarseComesBackFromTenDegrees) {
  const Surface source = scans().source(0.035), target = scans().target(0.035);
  const Refiner refiner(source, target, emtr::coarse_refinement());
  for (const double sign : {-1.0, 1.0}) {
    const LocalRefinementResult out =
        refiner(scans().off({7 * sign, 5, -5}, {0.03, -0.03 * sign, 0.03}));
    EXPECT_LT(degrees_between(out.pose, scans().truth), 0.5);
    EXPECT_EQ(out.inlier_share_target, 0);
  }
}

TEST(LocalRefinement, TwoPartsEndWhereTheWholeDoes) {
  const emtr::SharedSurface source(scans().source(0.035)), target(scans().target(0.035));
  const auto near = emtr::make_neighbors(target->points, 4 * 0.035f, 1e4, emtr::select_kernels());
  const LocalRefinement refine(source, target, nullptr, near.get(), emtr::coarse_refinement(),
                               emtr::select_kernels());
  LocalRefinement::Scratch scratch;
  for (const double degrees : {1.0, 7.0, 60.0, 180.0}) {
    const Rigid start = scans().off({degrees, 5, -5}, {0.03, 0, 0.03});
    const LocalRefinementResult whole = refine(start, nullptr, scratch),
                                first = refine.approach(start, nullptr, scratch),
                                both = refine.finish(start, first, nullptr, scratch);
    EXPECT_EQ(bits(both), bits(whole));
    EXPECT_EQ(both.end, whole.end);
    EXPECT_EQ(both.iterations, whole.iterations);
    EXPECT_EQ(first.iterations, 3);  // 4, 2.4 and 1.44 leaves, and then one
    EXPECT_NE(bits(first), bits(whole));
  }
  const Rigid far = scans().off({0, 0, 0}, {50, 0, 0});  // nothing is near
  const LocalRefinementResult none =
      refine.finish(far, refine.approach(far, nullptr, scratch), nullptr, scratch);
  EXPECT_EQ(none.end, Termination::TooFewInliers);
  LocalRefinementResult start;
  start.pose = far;
  EXPECT_EQ(bits(none), bits(start));
}

TEST(LocalRefinement, OfItsOwnResultMovesNoMore) {
  const Refiner refiner(scans().source(0.02), scans().target(0.02), LocalRefinementSettings());
  const LocalRefinementResult once = refiner(scans().off({0.5, 0.5, 0}, {0, 0.005, 0}));
  LocalRefinementSettings last;
  last.first_scale = last.last_scale;
  const Refiner again(scans().source(0.02), scans().target(0.02), last);
  const LocalRefinementResult twice = again(once.pose);
  EXPECT_EQ(twice.end, Termination::Converged);
  EXPECT_LT(degrees_between(once.pose, twice.pose), 1e-3);
}

TEST(LocalRefinement, SameBitsForAnyThreadsKernelsScratchAndSignsOfNormals) {
  Surface source = scans().source(0.02);
  const Surface target = scans().target(0.02);
  const Rigid start = scans().off({1, 0, 0.5}, {0.01, 0, 0});
  const auto wanted = bits(Refiner(source, target, LocalRefinementSettings())(start));
  for (const emtr::Kernels* kernels : emtr_test::kernels_here()) {
    const Refiner refiner(source, target, LocalRefinementSettings(), *kernels);
    for (const int threads : {1, 2, 3}) EXPECT_EQ(bits(refiner(start, threads)), wanted);
  }
  for (std::size_t i = 0; i < source.normals.size(); i += 3) {
    source.normals.x[i] = -source.normals.x[i];
    source.normals.y[i] = -source.normals.y[i];
    source.normals.z[i] = -source.normals.z[i];
  }
  const Refiner flipped(source, target, LocalRefinementSettings());
  LocalRefinement::Scratch used;
  (*flipped.local_refinement)(scans().truth, nullptr, used);
  EXPECT_EQ(bits((*flipped.local_refinement)(start, nullptr, used)), wanted);
}

TEST(LocalRefinement, SaysSoWhenNothingConstrainsIt) {
  Surface source = scans().source(0.03), target = scans().target(0.03);
  const Rigid away = motion({10, 20, 30}, {5, 0, 0});
  const LocalRefinementResult out = Refiner(source, target, LocalRefinementSettings())(away);
  EXPECT_EQ(out.end, Termination::TooFewInliers);
  LocalRefinementResult at_start;
  at_start.pose = away;
  EXPECT_EQ(bits(out), bits(at_start));
  EXPECT_EQ(out.rmse, 0);
  EXPECT_EQ(out.inlier_share_source, 0);

  for (auto* v : {&source.normals.x, &source.normals.y, &source.normals.z})
    std::fill(v->begin(), v->end(), std::numeric_limits<float>::quiet_NaN());
  const LocalRefinementResult none =
      Refiner(source, target, LocalRefinementSettings())(scans().truth);
  EXPECT_EQ(none.end, Termination::TooFewInliers);
}

TEST(LocalRefinement, OfAPlaneStaysWhereItIsUnconstrained) {
  const Refiner refiner(emtr::downsample_surface(emtr_test::plane(1, 20000, 0.001), 0.03),
                        emtr::downsample_surface(emtr_test::plane(2, 20000, 0.001), 0.03),
                        LocalRefinementSettings());
  const LocalRefinementResult out = refiner(motion({1, -1, 0}, {0.02, 0, 0.02}));
  EXPECT_NE(out.end, Termination::TooFewInliers);
  EXPECT_NEAR(out.pose.R(2, 2), 1, 1e-6);  // the plane lies in the other again
  EXPECT_NEAR(out.pose.R(2, 0) * 0 + out.pose.R(2, 2) * 0.1 + out.pose.t[2], 0.1, 5e-4);
  EXPECT_LT(translation_between(out.pose, motion({0, 0, 0}, {0.02, 0, 0})), 0.02);
}

TEST(LocalRefinement, RefusesWhatItCannotUse) {
  const Surface source = scans().source(0.05), target = scans().target(0.05);
  const auto refuses = [&](auto change) {
    LocalRefinementSettings settings;
    change(settings);
    EXPECT_THROW(Refiner(source, target, settings), emtr::Error);
  };
  refuses([](LocalRefinementSettings& s) { s.last_scale = 0; });
  refuses([](LocalRefinementSettings& s) { s.first_scale = 0.1; });
  refuses([](LocalRefinementSettings& s) { s.shrink = 1; });
  refuses([](LocalRefinementSettings& s) { s.normal_gate = 1; });
  refuses([](LocalRefinementSettings& s) { s.softness = 0; });
  refuses([](LocalRefinementSettings& s) { s.step = std::numeric_limits<double>::quiet_NaN(); });
  refuses([](LocalRefinementSettings& s) { s.iterations = 0; });
  refuses([](LocalRefinementSettings& s) { s.queries = 0; });
  refuses([](LocalRefinementSettings& s) { s.first_queries = 0; });
  refuses([](LocalRefinementSettings& s) { s.minimum_inliers = 5; });

  const auto near = emtr::make_brute_force(target.points, 0.1f);
  const auto build = [&](const Surface& s, const emtr::Neighbors* near_source) {
    return LocalRefinement(s, target, near_source, near.get(), LocalRefinementSettings(),
                           emtr::select_kernels());
  };
  EXPECT_THROW(build(source, nullptr), emtr::Error);
  Surface torn = source;
  torn.normals.resize(3);
  EXPECT_THROW(build(torn, near.get()), emtr::Error);

  Rigid start;
  start.t[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Refiner(source, target, LocalRefinementSettings())(start), emtr::Error);
}

// ---- within a prior -------------------------------------------------------------------

struct Bumps {
  emtr_test::Pair pair{71, 6000};
  emtr::NormalizedPair normalized = emtr::normalize(pair.source(), pair.target(), 1);
  emtr::Rigid truth = normalized.normalization.to_normalized(emtr::from_matrix(pair.pose()));
  emtr_test::Refiner refiner{emtr::downsample_surface(normalized.source, 0.03),
                             emtr::downsample_surface(normalized.target, 0.03),
                             emtr::LocalRefinementSettings()};

  emtr::LocalRefinementResult from(const emtr::Rigid& start, const emtr::Prior* prior) const {
    emtr::LocalRefinement::Scratch scratch;
    return (*refiner.local_refinement)(start, prior, scratch);
  }
  /// Settings with the axis that the true rotation is about.
  emtr::Settings upright() const {
    emtr::Settings s = emtr::preset("default");
    const Eigen::AngleAxisd rotation(truth.R);
    s.has_axis = 1;
    Eigen::Vector3d::Map(s.axis) = rotation.axis();
    return s;
  }
};

double step_left(const emtr::LocalRefinementResult& p,
                 const std::vector<emtr::Prior::Limit>& limits) {
  emtr::Matrix6 H;
  p.sums.full_matrix(H.data());
  return emtr::constrained_step(H, emtr::Vector6::Map(p.sums.g), limits).norm();
}

TEST(LocalRefinement, UprightItEndsInTheOptimumOfFour) {
  const Bumps bumps;
  const auto prior = emtr::make_prior(bumps.upright(), bumps.normalized.normalization);
  const emtr::Rigid start =
      prior->project(emtr_test::compose(emtr_test::motion({2, -1, 1}, {0.02, 0, 0}), bumps.truth));
  const emtr::LocalRefinementResult p = bumps.from(start, prior.get()),
                                    free = bumps.from(start, nullptr);
  EXPECT_EQ(p.end, emtr::Termination::Converged);
  EXPECT_TRUE(prior->admits(p.pose));
  EXPECT_FALSE(prior->admits(free.pose));
  EXPECT_LT(step_left(p, prior->limits(p.pose)), 5e-3 * 0.03);
  EXPECT_LT(emtr_test::degrees_between(p.pose, bumps.truth),
            emtr_test::degrees_between(free.pose, bumps.truth));
}

TEST(LocalRefinement, AtABorderTheRestMakesTheBestOfIt) {
  const Bumps bumps;
  emtr::Settings s = emtr::preset("default");
  s.has_guess = 1;  // 0.02 away, and no further than 0.01 from there
  emtr::Rigid guess = bumps.truth;
  guess.t[0] += 0.02;
  emtr::to_matrix(bumps.normalized.normalization.to_user(guess), s.guess);
  s.guess_translation = 0.01 * bumps.normalized.normalization.scale;
  const auto prior = emtr::make_prior(s, bumps.normalized.normalization);
  const emtr::LocalRefinementResult p = bumps.from(guess, prior.get()),
                                    free = bumps.from(guess, nullptr);
  EXPECT_EQ(p.end, emtr::Termination::Converged);
  EXPECT_TRUE(prior->admits(p.pose));
  const emtr::Rigid clipped = prior->project(free.pose);
  EXPECT_GT(emtr_test::translation_between(clipped, free.pose), 0.005);
  // A step is left, but none that the limits let through; and the rotation gave way.
  EXPECT_LT(step_left(p, prior->limits(p.pose)), 5e-3 * 0.03);
  EXPECT_GT(step_left(p, {}), 2e-3);
  EXPECT_GT(emtr_test::degrees_between(p.pose, clipped), 0.02);
}

}  // namespace
