#include <gtest/gtest.h>

#include <algorithm>

#include "evolution/engine.h"
#include "geometry/pose_distance.h"
#include "priors/make_prior.h"
#include "support/clouds.h"
#include "support/problems.h"

namespace {

using emtr::Evolution;
using emtr::Settings;

emtr_test::ProblemPtr problem_with(const Settings& settings) {
  const emtr_test::Pair pair(11, 5000);
  return emtr_test::problem_of(pair.source(), pair.target(), settings);
}

Evolution run(
    const emtr_test::ProblemPtr& p, const Settings& settings,
    const emtr::OnIteration& on_iteration = [](int, double, double) { return false; }) {
  return emtr::evolve(*p->alpha, *p->beta, *p->complement, settings, {}, on_iteration, nullptr);
}

class Engine : public testing::Test {
 protected:
  Settings settings = emtr::preset("paper");
  emtr_test::ProblemPtr problem = problem_with(settings);
  std::uint64_t sparse = problem->alpha->queries(EMTR_RESOLUTION_SPARSE);
  std::uint64_t dense = problem->alpha->queries(EMTR_RESOLUTION_DENSE);
};

TEST_F(Engine, QueriesFollowThePapersFormula) {
  const Evolution with = run(problem, settings);
  EXPECT_EQ(with.queries_evaluation, 50 * (60 * sparse + 40 * dense));
  EXPECT_EQ(with.queries_switch, 50 * dense);
  EXPECT_EQ(with.queries_complement % (20 * sparse), 0u);
  EXPECT_GT(with.queries_complement, 0u);

  settings.sparse_to_dense = 0;
  const Evolution without = run(problem, settings);
  EXPECT_EQ(without.queries_evaluation, 50 * 100 * dense);
  EXPECT_EQ(without.queries_switch, 0u);
}

TEST_F(Engine, SwitchesAtTheCeilingOfDelta) {
  settings.iterations = 7;  // ceil(0.6 * 7) = 5
  EXPECT_EQ(run(problem, settings).queries_evaluation, 50 * (5 * sparse + 2 * dense));
  settings.switch_fraction = 1;
  const Evolution never = run(problem, settings);
  EXPECT_EQ(never.queries_evaluation, 50 * 7 * sparse);
  EXPECT_EQ(never.resolution, EMTR_RESOLUTION_SPARSE);
  settings.switch_fraction = 0;
  EXPECT_EQ(run(problem, settings).queries_evaluation, 50 * 7 * dense);
}

TEST_F(Engine, HistoryNeverRisesButAtTheSwitch) {
  const Evolution e = run(problem, settings);
  ASSERT_EQ(e.history_alpha.size(), 100u);
  ASSERT_EQ(e.history_beta.size(), 100u);
  for (std::size_t i = 1; i < 100; ++i) {
    if (i == 60) continue;  // another objective from here on
    EXPECT_LE(e.history_alpha[i], e.history_alpha[i - 1]);
  }
  for (std::size_t i = 1; i < 100; ++i) EXPECT_LE(e.history_beta[i], e.history_beta[i - 1]);
  EXPECT_EQ(e.history_alpha.back(), e.hypotheses[e.best].fitness);
}

TEST_F(Engine, AfterTheSwitchEveryBestIsADenseFitness) {
  emtr::TaskAlpha::Scratch scratch;
  const Evolution e = run(problem, settings);
  EXPECT_EQ(e.resolution, EMTR_RESOLUTION_DENSE);
  for (const emtr::Hypothesis& h : e.hypotheses)
    EXPECT_EQ(h.fitness, problem->alpha->evaluate(EMTR_RESOLUTION_DENSE, h.pose, scratch));
}

TEST_F(Engine, SameBitsForAnyThreads) {
  settings.threads = 1;
  const Evolution one = run(problem, settings);
  for (const int threads : {2, 3, 4, 8}) {
    settings.threads = threads;
    const Evolution more = run(problem, settings);
    EXPECT_EQ(one.history_alpha, more.history_alpha);
    EXPECT_EQ(one.history_beta, more.history_beta);
    EXPECT_TRUE(one.hypotheses[one.best].pose.R == more.hypotheses[more.best].pose.R);
  }
}

TEST_F(Engine, SeedsDiffer) {
  const Evolution a = run(problem, settings);
  settings.seed = 1;
  EXPECT_NE(a.history_alpha, run(problem, settings).history_alpha);
}

TEST_F(Engine, AblationsDoWhatTheySay) {
  const Evolution all = run(problem, settings);
  Settings alone = settings;
  alone.transfer = 0;
  const Evolution apart = run(problem, alone);
  EXPECT_EQ(apart.queries_complement, 0u);
  EXPECT_NE(apart.history_alpha, all.history_alpha);

  // Without transfer task beta does not hear of alpha, so alpha's settings cannot matter to it.
  alone.translation_bound = 0.25;
  EXPECT_EQ(run(problem, alone).history_beta, apart.history_beta);

  Settings bare = settings;
  bare.complement = 0;
  EXPECT_EQ(run(problem, bare).queries_complement, 0u);
}

TEST_F(Engine, StopsWhenAsked) {
  const Evolution e = run(problem, settings, [](int done, double, double) { return done == 12; });
  EXPECT_TRUE(e.stopped);
  EXPECT_EQ(e.history_alpha.size(), 12u);
  EXPECT_EQ(e.hypotheses.size(), 50u);
}

TEST_F(Engine, AGuessIsOneHypothesis) {
  settings.iterations = 1;
  emtr::Rigid truth;
  const emtr_test::Pair pair(11, 5000);
  truth = problem->pair.normalization.to_normalized(emtr::from_matrix(pair.pose()));
  const Evolution e = emtr::evolve(
      *problem->alpha, *problem->beta, *problem->complement, settings, {{truth}, {}},
      [](int, double, double) { return false; }, nullptr);
  EXPECT_EQ(e.best, 0u);
  EXPECT_LT(emtr::rotation_distance(e.hypotheses[0].pose.R, truth.R), 1e-9);
}

class EngineSteps : public Engine {
 protected:
  EngineSteps() {
    settings.iterations = 40;
    const emtr_test::Pair pair(11, 5000);
    truth = problem->pair.normalization.to_normalized(emtr::from_matrix(pair.pose()));
  }
  Evolution started(const emtr::Starts& starts) const {
    return emtr::evolve(
        *problem->alpha, *problem->beta, *problem->complement, settings, starts,
        [](int, double, double) { return false; }, nullptr);
  }
  void use(emtr_when when) { settings.rotation_vector_steps = settings.arc_transfer = when; }
  emtr::Rigid truth;
};

TEST_F(EngineSteps, PresetPaperHasThemOff) {
  EXPECT_EQ(settings.rotation_vector_steps, EMTR_OFF);
  EXPECT_EQ(settings.arc_transfer, EMTR_OFF);
}

TEST_F(EngineSteps, AutoIsForSwarmsWithoutASeed) {
  emtr::Rigid near = truth;  // where the swarms still improve on it
  near.t[0] += 0.03;
  const emtr::Starts none, guess{{near}, {}}, seed{{}, {near}};
  use(EMTR_OFF);
  const auto off = started(none).history_alpha, off_at_seed = started(seed).history_alpha,
             off_at_guess = started(guess).history_alpha;
  EXPECT_EQ(off_at_guess, off_at_seed);  // with the same pose in the same place
  use(EMTR_ALWAYS);
  const auto on = started(none).history_alpha, on_at_seed = started(seed).history_alpha,
             on_at_guess = started(guess).history_alpha;
  EXPECT_NE(on, off);
  EXPECT_NE(on_at_seed, off_at_seed);
  use(EMTR_AUTO);
  EXPECT_EQ(started(none).history_alpha, on);
  EXPECT_EQ(started(guess).history_alpha, on_at_guess);
  EXPECT_EQ(started(seed).history_alpha, off_at_seed);
}

TEST_F(EngineSteps, EachDoesSomethingByItself) {
  const auto off = started({});
  use(EMTR_OFF);
  settings.arc_transfer = EMTR_ALWAYS;
  EXPECT_NE(started({}).history_alpha, off.history_alpha);
  use(EMTR_OFF);
  settings.rotation_vector_steps = EMTR_ALWAYS;
  EXPECT_NE(started({}).history_alpha, off.history_alpha);
}

/// From the truth as a seed, with candidates.
class EngineStall : public EngineSteps {
 protected:
  EngineStall() {
    settings.candidates = 12;
    settings.stall_iterations = 5;
  }
  std::size_t iterations(const emtr::Starts& starts) const {
    return started(starts).history_alpha.size();
  }
};

TEST_F(EngineStall, EndsWhereTheBestPoseStaysInOnePlace) {
  const Evolution e = started({{}, {truth}});
  EXPECT_EQ(e.history_alpha.size(), 6u);
  EXPECT_EQ(e.history_beta.size(), 6u);
  EXPECT_FALSE(e.stopped);
  EXPECT_EQ(e.resolution, EMTR_RESOLUTION_SPARSE);
  ASSERT_EQ(e.hypotheses.size(), 50u);
  EXPECT_TRUE(emtr::is_same_pose(e.hypotheses[e.best].pose, truth, emtr::kDuplicatePose));
}

TEST_F(EngineStall, TheIterationsBeforeAreTheSame) {
  const auto ended = started({{}, {truth}}).history_alpha;
  settings.stall_iterations = 0;
  auto whole = started({{}, {truth}}).history_alpha;
  ASSERT_EQ(whole.size(), 40u);
  whole.resize(ended.size());
  EXPECT_EQ(ended, whole);
}

TEST_F(EngineStall, GoesOnWhereThePoseMoves) {
  emtr::Rigid wrong = truth;
  wrong.R = Eigen::AngleAxisd(2, Eigen::Vector3d::UnitX()) * wrong.R;
  wrong.t[0] += 0.3;
  EXPECT_GT(iterations({{}, {wrong}}), 6u);
}

TEST_F(EngineStall, IsForSeedsWithCandidates) {
  EXPECT_EQ(iterations({}), 40u);
  EXPECT_EQ(iterations({{truth}, {}}), 40u);  // a guess is no seed
  settings.candidates = 0;
  EXPECT_EQ(iterations({{}, {truth}}), 40u);
}

TEST_F(EngineSteps, SameBitsForAnyThreads) {
  use(EMTR_ALWAYS);
  settings.threads = 1;
  const Evolution one = started({});
  for (const int threads : {2, 3, 8}) {
    settings.threads = threads;
    const Evolution more = started({});
    EXPECT_EQ(one.history_alpha, more.history_alpha);
    EXPECT_EQ(one.history_beta, more.history_beta);
    ASSERT_EQ(one.hypotheses.size(), more.hypotheses.size());
    for (std::size_t i = 0; i < one.hypotheses.size(); ++i)
      EXPECT_TRUE(one.hypotheses[i].pose.R == more.hypotheses[i].pose.R);
  }
}

TEST_F(EngineSteps, KeepToAPrior) {
  use(EMTR_ALWAYS);
  for (const int which : {0, 1, 2}) {
    emtr::Settings known = settings;
    if (which == 0) known.maximum_rotation = 170;
    if (which == 1) {
      known.has_axis = 1;
      known.axis[2] = 1;
      known.axis_tilt = 20;
    }
    if (which == 2) {
      known.has_translation_bounds = 1;
      for (int a = 0; a < 3; ++a) {
        known.translation_minimum[a] = -0.2;
        known.translation_maximum[a] = 0.3;
      }
    }
    const auto prior = emtr::make_prior(known, problem->pair.normalization);
    ASSERT_TRUE(prior);
    const Evolution e = emtr::evolve(
        *problem->alpha, *problem->beta, *problem->complement, known, {},
        [](int, double, double) { return false; }, prior.get());
    for (const emtr::Hypothesis& h : e.hypotheses) EXPECT_TRUE(prior->admits(h.pose)) << which;
  }
}

}  // namespace
