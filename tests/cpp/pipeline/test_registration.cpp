#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>

#include "refinement/shapes.h"
#include "support/clouds.h"
#include "support/problems.h"

namespace {

using emtr::Settings;
using emtr_test::Pair;
using emtr_test::ResultPtr;

Settings preset(const char* name, int threads = 1) {
  Settings settings = emtr::preset(name);
  settings.threads = threads;
  return settings;
}

ResultPtr solve(const emtr_cloud& source, const emtr_cloud& target, const Settings& settings) {
  return emtr_test::solve(*emtr_test::problem_of(source, target, settings));
}

ResultPtr solve(const Pair& pair, const Settings& settings) {
  return solve(pair.source(), pair.target(), settings);
}

/// Sets the variable EMTR_KERNEL for as long as it lives.
class Asked {
 public:
  explicit Asked(const char* name) { setenv("EMTR_KERNEL", name, 1); }
  ~Asked() { unsetenv("EMTR_KERNEL"); }
};

// ---- every preset ---------------------------------------------------------------------

class OfPreset : public testing::TestWithParam<const char*> {};

TEST_P(OfPreset, RegistersAPairAndFillsTheResult) {
  const Pair pair(61, 4000, 50);
  const Settings settings = preset(GetParam(), 2);
  const ResultPtr r = solve(pair, settings);
  EXPECT_LT(pair.error(r->transformation), settings.refine ? 0.01 : 0.05);
  EXPECT_EQ(r->registered, 1);
  EXPECT_EQ(r->reason, EMTR_REASON_REGISTERED);
  EXPECT_TRUE(emtr::is_rigid(r->transformation));

  EXPECT_EQ(r->size, sizeof(emtr_result));
  EXPECT_GT(r->fitness, 0);
  EXPECT_LT(r->fitness, 0.8);
  for (const double ratio : {r->inlier_ratio_source, r->inlier_ratio_target}) {
    EXPECT_GT(ratio, 0.5);
    EXPECT_LE(ratio, 1);
  }
  EXPECT_GT(r->inlier_rmse, 0);
  EXPECT_LT(r->inlier_rmse, r->leaf_fine * r->normalization_scale);
  EXPECT_GT(r->inlier_rmse_plane, 0);
  EXPECT_LT(r->inlier_rmse_plane, r->inlier_rmse);
  EXPECT_GT(r->overlap_source, 0.5);
  EXPECT_GT(r->overlap_target, 0.5);
  EXPECT_GT(r->fitness_gap, 0);
  EXPECT_EQ(r->points_source, 4000u);
  EXPECT_EQ(r->points_target, 4000u);
  EXPECT_EQ(r->dropped_source + r->dropped_target, 0u);
  EXPECT_GT(r->sparse_source, 100u);
  EXPECT_GT(r->dense_source, r->sparse_source);
  EXPECT_GT(r->dense_target, r->sparse_target);
  EXPECT_GT(r->correspondences, 10u);
  EXPECT_LE(r->correspondences, static_cast<std::size_t>(settings.max_correspondences));
  EXPECT_GT(r->tims, r->tims_pruned);
  EXPECT_GT(r->queries_evaluation, 0u);
  const double switch_at = std::ceil(settings.switch_fraction * settings.iterations);
  EXPECT_EQ(r->queries_switch > 0, static_cast<double>(r->iterations) > switch_at);
  EXPECT_GT(r->queries_complement, 0u);
  EXPECT_NEAR(r->normalization_scale / pair.unit(), 1, 0.5);
  EXPECT_GT(r->leaf_sparse, r->leaf_dense);
  EXPECT_GT(r->leaf_dense, 0);
  // With seeds the best pose stays in one place, from the first one on where there are many.
  const auto all = static_cast<std::size_t>(settings.iterations),
             stalled = static_cast<std::size_t>(1 + settings.stall_iterations);
  const bool may_stall = settings.candidates > 0, is_fast = std::string(GetParam()) == "fast";
  EXPECT_GE(r->iterations, may_stall ? stalled : all);
  EXPECT_LE(r->iterations, may_stall && !is_fast ? stalled : all);
  EXPECT_LE(r->history_beta[r->iterations - 1], r->history_beta[0]);
  EXPECT_GE(r->history_alpha[0], r->history_alpha[1]);
  EXPECT_EQ(r->seed, settings.seed);
  EXPECT_EQ(r->threads, 2);
  EXPECT_STREQ(r->kernel, emtr_kernel_name());
}

TEST_P(OfPreset, FillsWhatItsStagesMake) {
  const Pair pair(61, 4000, 50);
  const Settings settings = preset(GetParam());
  const ResultPtr r = solve(pair, settings);
  EXPECT_EQ(r->seeds > 0, settings.seeds > 0);
  EXPECT_LE(r->seeds, static_cast<std::size_t>(settings.seeds));
  const bool ranked = settings.candidates > 0;
  EXPECT_EQ(r->candidates > 0, ranked);
  for (const double v : {r->confidence, r->score, r->surface_fit, r->violation, r->score_gap})
    EXPECT_EQ(std::isfinite(v), ranked);
  if (ranked) {
    EXPECT_GE(r->confidence, settings.minimum_confidence);
    EXPECT_LE(r->confidence, 1);
    EXPECT_LE(r->score, 1);
    EXPECT_GE(r->surface_fit, r->score);
    EXPECT_GE(r->violation, 0);
    EXPECT_GT(r->score_gap, 0);
    EXPECT_LE(r->score_gap, r->score);
  }
  ASSERT_LE(r->alternative_count, 10u);
  for (std::size_t i = 0; i < r->alternative_count; ++i) {
    EXPECT_TRUE(emtr::is_rigid(r->alternatives[i].transformation));
    EXPECT_LE(r->alternatives[i].score, i ? r->alternatives[i - 1].score : r->score);
    EXPECT_GT(pair.error(r->alternatives[i].transformation), 0.05);
  }
  EXPECT_EQ(r->used_fallback_search,
            settings.fallback_search == EMTR_ALWAYS);  // the pair is an easy one
  EXPECT_EQ(r->refined, settings.refine);
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(std::isfinite(r->hessian_eigenvalues[i]), settings.refine != 0);
    EXPECT_EQ(std::isfinite(r->information[7 * i]), settings.refine != 0);
    EXPECT_EQ(std::isfinite(r->hessian_eigenvectors[7 * i]), settings.refine != 0);
  }
  EXPECT_EQ(r->unconstrained_directions, settings.refine ? 0 : -1);

  EXPECT_GT(r->seconds_normalization, 0);
  EXPECT_GT(r->seconds_features, 0);
  EXPECT_GT(r->seconds_evolution, 0);
  EXPECT_EQ(r->seconds_candidates > 0, ranked);
  EXPECT_EQ(r->seconds_fallback_search > 0, r->used_fallback_search != 0);
  EXPECT_EQ(r->seconds_refinement > 0, r->refined != 0);
  EXPECT_GT(r->seconds_total, r->seconds_evolution);
}

INSTANTIATE_TEST_SUITE_P(Registration, OfPreset,
                         testing::Values("default", "fast", "thorough", "paper"),
                         [](const auto& of) { return std::string(of.param); });

TEST(Registration, EveryPresetIsTestedHere) {
  EXPECT_STREQ(emtr::preset_name(3), "paper");
  EXPECT_EQ(emtr::preset_name(4), nullptr);
}

// ---- the same bits --------------------------------------------------------------------

/// All but the seconds, the threads and the kernel's name.
void expect_same(const emtr::Result& a, const emtr::Result& b, const std::string& what) {
  SCOPED_TRACE(what);
  const auto same = [](const auto& x, const auto& y) { return !std::memcmp(&x, &y, sizeof x); };
  // In the order of the stages: the first that fails says where it begins.
  EXPECT_TRUE(same(a.normalization_scale, b.normalization_scale) &&
              same(a.center_source, b.center_source) && same(a.center_target, b.center_target))
      << "normalization";
  EXPECT_TRUE(same(a.leaf_sparse, b.leaf_sparse) && same(a.leaf_dense, b.leaf_dense) &&
              a.sparse_source == b.sparse_source && a.sparse_target == b.sparse_target &&
              a.dense_source == b.dense_source && a.dense_target == b.dense_target)
      << "downsampling";
  EXPECT_TRUE(a.correspondences == b.correspondences && a.tims == b.tims &&
              a.tims_pruned == b.tims_pruned)
      << "matching";
  EXPECT_EQ(a.seeds, b.seeds);
  EXPECT_TRUE(a.alpha == b.alpha && a.beta == b.beta &&
              a.queries_evaluation == b.queries_evaluation &&
              a.queries_switch == b.queries_switch && a.queries_complement == b.queries_complement)
      << "evolution";
  EXPECT_TRUE(a.candidates == b.candidates && same(a.score, b.score) &&
              same(a.surface_fit, b.surface_fit) && same(a.violation, b.violation) &&
              same(a.score_gap, b.score_gap) && same(a.confidence, b.confidence) &&
              a.used_fallback_search == b.used_fallback_search)
      << "candidates";
  ASSERT_EQ(a.others.size(), b.others.size());
  for (std::size_t i = 0; i < a.others.size(); ++i)
    EXPECT_TRUE(same(a.others[i], b.others[i])) << "alternative " << i;
  EXPECT_TRUE(a.refined == b.refined && same(a.information, b.information) &&
              same(a.hessian_eigenvalues, b.hessian_eigenvalues) &&
              same(a.hessian_eigenvectors, b.hessian_eigenvectors) &&
              a.unconstrained_directions == b.unconstrained_directions)
      << "refinement";
  EXPECT_TRUE(same(a.transformation, b.transformation)) << "answer";
  EXPECT_TRUE(
      same(a.fitness, b.fitness) && same(a.inlier_ratio_source, b.inlier_ratio_source) &&
      same(a.inlier_ratio_target, b.inlier_ratio_target) && same(a.inlier_rmse, b.inlier_rmse) &&
      same(a.overlap_source, b.overlap_source) && same(a.overlap_target, b.overlap_target) &&
      same(a.leaf_fine, b.leaf_fine) && same(a.inlier_rmse_plane, b.inlier_rmse_plane) &&
      same(a.fitness_gap, b.fitness_gap) && a.registered == b.registered && a.reason == b.reason)
      << "verdict";
}

TEST(Registration, DefaultIsTheSameBitsForAnyThreads) {
  const Pair pair(62, 4000);
  const ResultPtr one = solve(pair, preset("default", 1));
  for (const int threads : {2, 3, 8})
    expect_same(*one, *solve(pair, preset("default", threads)), std::to_string(threads));
}

TEST(Registration, DefaultIsTheSameBitsWithAnyKernels) {
  const Pair pair(63, 4000);
  const ResultPtr best = solve(pair, preset("default"));
  for (const emtr::Kernels* k : emtr_test::kernels_here()) {
    const Asked asked(k->name);
    const ResultPtr other = solve(pair, preset("default"));
    EXPECT_STREQ(other->kernel, k->name);
    expect_same(*best, *other, k->name);
  }
}

TEST(Registration, FallbackSearchIsTheSameBitsForAnyThreadsAndKernels) {
  const Pair pair(64, 3000);
  const ResultPtr one = solve(pair, preset("thorough", 1));
  ASSERT_TRUE(one->used_fallback_search);
  expect_same(*one, *solve(pair, preset("thorough", 3)), "3 threads");
  const Asked asked("generic");
  expect_same(*one, *solve(pair, preset("thorough", 2)), "2 threads, generic");
}

TEST(Registration, FastIsTheSameBitsForAnyThreads) {
  const Pair pair(65, 4000);
  expect_same(*solve(pair, preset("fast", 1)), *solve(pair, preset("fast", 4)), "4");
}

TEST(Registration, SolvingAgainGivesTheSameBits) {
  const Pair pair(66, 4000);
  const auto problem = emtr_test::problem_of(pair.source(), pair.target(), preset("default", 2));
  const ResultPtr first = emtr_test::solve(*problem);
  expect_same(*first, *emtr_test::solve(*problem), "again");
  expect_same(*first, *solve(pair, preset("default", 2)), "anew");
}

TEST(Registration, AnotherSeedGivesOtherBitsAndTheSameAnswer) {
  const Pair pair(66, 4000);
  Settings settings = preset("default");
  settings.injected_seeds = 0;  // else the best of both swarms is a seed from the start
  const ResultPtr a = solve(pair, settings);
  settings.seed = 1;
  const ResultPtr b = solve(pair, settings);
  EXPECT_NE(a->alpha, b->alpha);
  EXPECT_NE(a->beta, b->beta);
  EXPECT_LT(pair.error(a->transformation), 0.01);
  EXPECT_LT(pair.error(b->transformation), 0.01);
}

// ---- units ----------------------------------------------------------------------------

TEST(Registration, TheUnitScalesTheResultAndNothingElse) {
  constexpr double unit = 64;  // a power of two, so that no digit changes
  const Pair one(66, 3000), large(66, 3000, unit);
  const ResultPtr a = solve(one, preset("default")), b = solve(large, preset("default"));
  EXPECT_EQ(b->normalization_scale, unit * a->normalization_scale);
  EXPECT_EQ(b->inlier_rmse, unit * a->inlier_rmse);
  EXPECT_EQ(b->inlier_rmse_plane, unit * a->inlier_rmse_plane);
  EXPECT_EQ(b->overlap_source, a->overlap_source);
  EXPECT_EQ(b->score, a->score);
  EXPECT_EQ(b->confidence, a->confidence);
  EXPECT_EQ(b->leaf_dense, a->leaf_dense);
  EXPECT_EQ(b->alpha, a->alpha);
  for (std::size_t i = 0; i < 12; ++i)
    EXPECT_EQ(b->transformation[i], (i % 4 == 3 ? unit : 1) * a->transformation[i]) << i;
  ASSERT_EQ(a->refined, 1);
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) {
      const double units = (i < 3 ? 1 : unit) * (j < 3 ? 1 : unit);
      EXPECT_NEAR(b->information[6 * i + j] * units / a->information[6 * i + j], 1, 1e-12);
      EXPECT_EQ(b->hessian_eigenvectors[6 * i + j], a->hessian_eigenvectors[6 * i + j]);
    }
  ASSERT_EQ(a->alternative_count, b->alternative_count);
  for (std::size_t k = 0; k < a->alternative_count; ++k)
    for (std::size_t i = 0; i < 12; ++i)
      EXPECT_EQ(b->others[k].transformation[i],
                (i % 4 == 3 ? unit : 1) * a->others[k].transformation[i]);
}

// ---- what cannot be registered --------------------------------------------------------

TEST(Registration, UnrelatedCloudsAreNotRegistered) {
  for (const std::uint64_t seed : {71u, 73u, 75u}) {
    const Pair a(seed, 3000), b(seed + 1, 3000);
    const ResultPtr r = solve(a.source(), b.target(), preset("default"));
    EXPECT_EQ(r->registered, 0) << seed;
    EXPECT_NE(r->reason, EMTR_REASON_REGISTERED) << seed;
    EXPECT_NE(r->reason, EMTR_REASON_INTERRUPTED) << seed;
    EXPECT_LT(r->confidence, 0.5) << seed;
    EXPECT_TRUE(r->used_fallback_search) << seed;
    EXPECT_TRUE(emtr::is_rigid(r->transformation)) << seed;
  }
}

/// Two samples of a whole shape, the second one moved.
struct Symmetric {
  std::vector<float> source, target;
  emtr::Rigid pose = emtr_test::motion({40, -70, 110}, {0.3, -0.2, 0.1});

  template <class Shape>
  explicit Symmetric(Shape shape) {
    const emtr::Cloud a = shape(1), b = shape(2);
    for (std::size_t i = 0; i < a.size(); ++i)
      source.insert(source.end(), {a.x[i], a.y[i], a.z[i]});
    for (std::size_t i = 0; i < b.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k)
        target.push_back(static_cast<float>(pose.R(k, 0) * double{b.x[i]} +
                                            pose.R(k, 1) * double{b.y[i]} +
                                            pose.R(k, 2) * double{b.z[i]} + pose.t[k]));
  }
  ResultPtr solve(const Settings& settings) const {
    return ::solve({source.data(), source.size() / 3, 0, EMTR_FLOAT32},
                   {target.data(), target.size() / 3, 0, EMTR_FLOAT32}, settings);
  }
};

void expect_doubt(const emtr::Result& r) {
  EXPECT_EQ(r.registered, 0);
  EXPECT_TRUE(r.reason == EMTR_REASON_AMBIGUOUS || r.reason == EMTR_REASON_DEGENERATE)
      << emtr_reason_text(r.reason) << ", confidence " << r.confidence << ", score " << r.score
      << ", gap " << r.score_gap << ", free " << r.unconstrained_directions;
  ASSERT_GT(r.alternative_count, 0u);
  EXPECT_GT(r.alternatives[0].score, 0.8 * r.score);
}

TEST(Registration, AVaseCanRotateAboutItsAxis) {
  const Symmetric vase([](std::uint64_t seed) {
    return emtr_test::Draw(seed).cloud(3000, 0.002, [](emtr_test::Draw& d) {
      const double z = d.uniform(-1, 1), angle = d.uniform(0, 2 * M_PI);
      const double radius = 0.4 + 0.15 * std::sin(3 * z) + 0.1 * z * z;
      return Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), z);
    });
  });
  const ResultPtr r = vase.solve(preset("default"));
  EXPECT_EQ(r->reason, EMTR_REASON_DEGENERATE);
  EXPECT_EQ(r->unconstrained_directions, 1);
  EXPECT_GT(r->confidence, 0.9);  // but for the rotation, which makes no other answer
  EXPECT_LT(r->score_gap, r->score);
  if (r->alternative_count) {
    EXPECT_LT(r->alternatives[0].score, 0.8 * r->score);
  }
}

TEST(Registration, ABoxLooksTheSameAfterHalfATurn) {
  const Symmetric box([](std::uint64_t seed) {
    emtr::Cloud out = emtr_test::cube(seed, 3000, 0.002);
    for (float& v : out.x) v *= 1.6f;
    for (float& v : out.y) v *= 1.25f;
    return out;
  });
  const ResultPtr r = box.solve(preset("default"));
  expect_doubt(*r);
  EXPECT_EQ(r->unconstrained_directions, 0);  // it is held, only not known which way
}

// ---- interruption ---------------------------------------------------------------------

emtr::OnProgress stop_at(const std::string& stage, int iteration = 0) {
  return [=](const emtr_progress& p) { return p.stage == stage && p.iteration == iteration; };
}

void expect_interrupted(const emtr::Result& r) {
  EXPECT_EQ(r.registered, 0);
  EXPECT_EQ(r.reason, EMTR_REASON_INTERRUPTED);
}

TEST(Registration, StoppedWhileTheProblemIsMadeThereIsNoPose) {
  const Pair pair(67, 2000);
  for (const char* stage : {"normalization", "downsampling", "features", "matching", "seeds"}) {
    SCOPED_TRACE(stage);
    const emtr::OnProgress progress = stop_at(stage);
    const auto problem =
        emtr_test::problem_of(pair.source(), pair.target(), preset("default"), progress);
    EXPECT_TRUE(problem->stopped);
    const ResultPtr r = emtr_test::solve(*problem, progress);
    expect_interrupted(*r);
    for (const double v : r->transformation) EXPECT_TRUE(std::isnan(v));
    EXPECT_TRUE(std::isnan(r->confidence));
    EXPECT_EQ(r->iterations + r->candidates + r->alternative_count, 0u);
  }
}

TEST(Registration, StoppedLaterTheBestPoseSoFarIsGiven) {
  const Pair pair(68, 3000);
  Settings settings = preset("thorough");
  settings.stall_iterations = 0;
  settings.fallback_points = 4000;
  const auto problem = emtr_test::problem_of(pair.source(), pair.target(), settings);
  const auto stopped = [&](const char* stage, int iteration = 0) {
    SCOPED_TRACE(stage);
    ResultPtr r = emtr_test::solve(*problem, stop_at(stage, iteration));
    expect_interrupted(*r);
    return r;
  };
  const ResultPtr seed = stopped("evolution");
  const ResultPtr early = stopped("evolution", 3), candidates = stopped("candidates");
  EXPECT_EQ(seed->iterations, 0u);
  EXPECT_TRUE(std::isnan(seed->fitness_gap));
  EXPECT_EQ(early->iterations, 3u);
  EXPECT_EQ(early->alpha.size(), 3u);
  EXPECT_EQ(candidates->iterations, static_cast<std::size_t>(settings.iterations));
  for (const emtr::Result* r : {seed.get(), early.get(), candidates.get()}) {
    EXPECT_TRUE(emtr::is_rigid(r->transformation));
    EXPECT_LE(r->fitness, 1);
    EXPECT_EQ(r->candidates, 0u);
    EXPECT_TRUE(std::isnan(r->confidence));
  }

  const ResultPtr fallback_search = stopped("fallback_search");
  EXPECT_GT(fallback_search->candidates, 0u);
  EXPECT_FALSE(fallback_search->used_fallback_search);
  const ResultPtr refinement = stopped("refinement");
  EXPECT_TRUE(refinement->used_fallback_search);
  EXPECT_FALSE(refinement->refined);
  const ResultPtr verdict = stopped("verdict");
  EXPECT_TRUE(verdict->refined);
  for (const emtr::Result* r : {fallback_search.get(), refinement.get(), verdict.get()}) {
    EXPECT_LT(pair.error(r->transformation), 0.05);
    EXPECT_GT(r->confidence, 0.5);
  }
  EXPECT_LT(pair.error(verdict->transformation), 0.002);
}

TEST(Registration, TellsEveryStageInItsOrder) {
  const Pair pair(69, 2000);
  Settings settings = preset("thorough");
  settings.stall_iterations = 0;
  settings.fallback_points = 3000;
  std::string stages, last;
  int iterations = 0;
  const emtr::OnProgress progress = [&](const emtr_progress& p) {
    if (p.stage != last) stages += (last = p.stage) + " ";
    if (p.iteration > iterations) {  // the same may be told again while it lasts
      EXPECT_EQ(p.iteration, ++iterations);
    }
    return false;
  };
  const auto problem = emtr_test::problem_of(pair.source(), pair.target(), settings, progress);
  EXPECT_FALSE(problem->stopped);
  emtr_test::solve(*problem, progress);
  EXPECT_EQ(stages,
            "normalization downsampling features matching seeds evolution candidates "
            "fallback_search refinement "
            "verdict ");
  EXPECT_EQ(iterations, settings.iterations);
}

// ---- guesses and sensors --------------------------------------------------------------

TEST(Registration, AWrongGuessDoesNoHarm) {
  const Pair pair(70, 3000);
  Settings settings = preset("default");
  settings.has_guess = 1;
  emtr::to_matrix(emtr_test::motion({90, 0, 0}, {0.2, 0, 0}), settings.guess);
  EXPECT_LT(pair.error(solve(pair, settings)->transformation), 0.01);
}

}  // namespace
