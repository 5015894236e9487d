#include <gtest/gtest.h>

#include <algorithm>

#include "evolution/engine.h"
#include "problem.h"
#include "support/clouds.h"

namespace {

using emtr::Evolution;
using emtr::Settings;

emtr::Problem problem_with(const Settings& settings) {
  const emtr_test::Pair pair(11, 5000);
  return {pair.source(), pair.target(), settings, nullptr};
}

Evolution run(
    const emtr::Problem& p, const Settings& settings,
    const emtr::OnIteration& on_iteration = [](int, double, double) { return false; }) {
  return emtr::evolve(*p.alpha, *p.beta, *p.complement, settings, {}, on_iteration);
}

class Engine : public testing::Test {
 protected:
  Settings settings = emtr::preset("paper");
  emtr::Problem problem = problem_with(settings);
  std::uint64_t sparse = problem.alpha->lookups(EMTR_STAGE_SPARSE);
  std::uint64_t dense = problem.alpha->lookups(EMTR_STAGE_DENSE);
};

TEST_F(Engine, LookUpsAreThePapersFormula) {
  const Evolution with = run(problem, settings);
  EXPECT_EQ(with.lookups_evaluation, 50 * (60 * sparse + 40 * dense));
  EXPECT_EQ(with.lookups_switch, 50 * dense);
  EXPECT_EQ(with.lookups_complement % (20 * sparse), 0u);
  EXPECT_GT(with.lookups_complement, 0u);

  settings.sparse_to_dense = 0;
  const Evolution without = run(problem, settings);
  EXPECT_EQ(without.lookups_evaluation, 50 * 100 * dense);
  EXPECT_EQ(without.lookups_switch, 0u);
}

TEST_F(Engine, SwitchesAtTheCeilingOfDelta) {
  settings.iterations = 7;  // ceil(0.6 * 7) = 5
  EXPECT_EQ(run(problem, settings).lookups_evaluation, 50 * (5 * sparse + 2 * dense));
  settings.switch_fraction = 1;
  const Evolution never = run(problem, settings);
  EXPECT_EQ(never.lookups_evaluation, 50 * 7 * sparse);
  EXPECT_EQ(never.stage, EMTR_STAGE_SPARSE);
  settings.switch_fraction = 0;
  EXPECT_EQ(run(problem, settings).lookups_evaluation, 50 * 7 * dense);
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
  EXPECT_EQ(e.stage, EMTR_STAGE_DENSE);
  for (const emtr::Hypothesis& h : e.hypotheses)
    EXPECT_EQ(h.fitness, problem.alpha->evaluate(EMTR_STAGE_DENSE, h.pose, scratch));
}

TEST_F(Engine, SameBitsForAnyThreads) {
  settings.threads = 1;
  const Evolution one = run(problem, settings);
  for (const int threads : {2, 3, 4, 8}) {
    settings.threads = threads;
    const Evolution more = run(problem, settings);
    EXPECT_EQ(one.history_alpha, more.history_alpha);
    EXPECT_EQ(one.history_beta, more.history_beta);
    EXPECT_TRUE(std::equal(one.hypotheses[one.best].pose.R, one.hypotheses[one.best].pose.R + 9,
                           more.hypotheses[more.best].pose.R));
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
  EXPECT_EQ(apart.lookups_complement, 0u);
  EXPECT_NE(apart.history_alpha, all.history_alpha);

  // Without transfer task beta does not hear of alpha, so alpha's settings cannot matter to it.
  alone.translation_bound = 0.25;
  EXPECT_EQ(run(problem, alone).history_beta, apart.history_beta);

  Settings bare = settings;
  bare.complement = 0;
  EXPECT_EQ(run(problem, bare).lookups_complement, 0u);
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
  truth = problem.frame.to_normalised(emtr::from_matrix(pair.pose()));
  const Evolution e = emtr::evolve(*problem.alpha, *problem.beta, *problem.complement, settings,
                                   {truth}, [](int, double, double) { return false; });
  EXPECT_EQ(e.best, 0u);
  EXPECT_LT(emtr::rotation_distance(e.hypotheses[0].pose.R, truth.R), 1e-9);
}

}  // namespace
