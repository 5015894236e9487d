#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "evolution/restarts.h"

namespace {

using emtr::Restarts;
using emtr::RotationSteps;
using emtr::Stream;
using emtr::Swarm;

class RestartsTest : public testing::Test {
 protected:
  RestartsTest() {
    settings.population = 10;
    for (const Stream stream : {Stream::Alpha, Stream::Beta})
      swarms.emplace_back(stream == Stream::Alpha ? emtr::pose_genes(0.5) : emtr::rotation_genes(),
                          settings, stream, RotationSteps::Angles);
  }
  /// Particle i has fitness i + 1: the first is gbest.
  void evaluate() {
    for (Swarm& swarm : swarms) {
      for (std::size_t i = 0; i < swarm.size(); ++i)
        swarm.fitness()[i] = static_cast<double>(i + 1);
      swarm.update_bests();
    }
  }
  Swarm& poses() { return swarms[0]; }
  Swarm& rotations() { return swarms[1]; }
  static std::vector<double> position(const Swarm& swarm, std::size_t i) {
    return {swarm.position(i), swarm.position(i) + swarm.dimensions()};
  }

  emtr::Settings settings = emtr::preset("default");
  std::vector<Swarm> swarms;
};

TEST_F(RestartsTest, ComeAfterSoManyIterationsWithoutABetterBest) {
  evaluate();
  Restarts restarts(3, 0.5);
  std::vector<int> due;
  for (int it = 0; it < 9; ++it) {
    restarts.after(it, poses(), rotations());
    if (poses().best_fitness(9) == HUGE_VAL) due.push_back(it);
    evaluate();
  }
  EXPECT_EQ(due, (std::vector<int>{3, 6}));  // the first iteration's best is news
}

TEST_F(RestartsTest, DoNotComeWhileTheBestGetsBetter) {
  Restarts restarts(1, 0.5);
  for (int it = 0; it < 5; ++it) {
    for (Swarm& swarm : swarms) {
      std::fill(swarm.fitness().begin(), swarm.fitness().end(), 10 - it);
      swarm.update_bests();
    }
    restarts.after(it, poses(), rotations());
  }
  EXPECT_TRUE(restarts.left().empty());
}

TEST_F(RestartsTest, NeverWithoutPatience) {
  Restarts restarts(0, 0.5);
  evaluate();
  for (int it = 0; it < 50; ++it) restarts.after(it, poses(), rotations());
  EXPECT_TRUE(restarts.left().empty());
}

TEST_F(RestartsTest, DrawTheWorstAnewAndRememberWhatTheyKnew) {
  evaluate();
  const Swarm before = poses();
  Restarts restarts(1, 0.3);
  restarts.after(0, poses(), rotations());
  restarts.after(1, poses(), rotations());
  ASSERT_EQ(restarts.left().size(), 3u);
  for (std::size_t i = 0; i < 10; ++i) {
    const bool worst = i >= 7;
    EXPECT_EQ(position(poses(), i) != position(before, i), worst) << i;
    EXPECT_EQ(poses().best_fitness(i), worst ? HUGE_VAL : static_cast<double>(i + 1));
    EXPECT_EQ(rotations().best_fitness(i), worst ? HUGE_VAL : static_cast<double>(i + 1));
  }
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(restarts.left()[k].fitness, static_cast<double>(8 + k));
    EXPECT_TRUE(std::equal(before.best_position(7 + k), before.best_position(7 + k) + 6,
                           restarts.left()[k].position.begin()));
  }
}

TEST_F(RestartsTest, NeverLoseTheBest) {
  evaluate();
  const std::vector<double> best = position(poses(), 0);
  Restarts restarts(1, 1);  // all there are
  for (int it = 0; it < 20; ++it) {
    restarts.after(it, poses(), rotations());
    EXPECT_EQ(poses().gbest(), 0u);
    EXPECT_EQ(poses().gbest_fitness(), 1);
    EXPECT_EQ(rotations().gbest_fitness(), 1);
    EXPECT_TRUE(std::equal(best.begin(), best.end(), poses().gbest_position()));
    evaluate();
  }
  // As many are remembered as there are particles, the best ones.
  EXPECT_EQ(restarts.left().size(), 10u);
  EXPECT_TRUE(std::is_sorted(restarts.left().begin(), restarts.left().end(),
                             [](const auto& a, const auto& b) { return a.fitness < b.fitness; }));
}

TEST_F(RestartsTest, AnotherObjectiveIsNoStagnation) {
  evaluate();
  Restarts restarts(2, 0.5);
  restarts.after(0, poses(), rotations());
  restarts.after(1, poses(), rotations());
  poses().set_best_fitness(std::vector<double>(10, 100));  // worse by number, and news
  restarts.objective_changed();
  restarts.after(2, poses(), rotations());
  restarts.after(3, poses(), rotations());
  EXPECT_TRUE(restarts.left().empty());
  restarts.after(4, poses(), rotations());
  EXPECT_EQ(restarts.left().size(), 5u);
}

TEST_F(RestartsTest, DrawWhatSeedAndIterationSay) {
  Swarm same = poses(), later = poses();
  poses().restart(4, 11);
  same.restart(4, 11);
  later.restart(4, 12);
  EXPECT_EQ(position(poses(), 4), position(same, 4));
  EXPECT_NE(position(poses(), 4), position(later, 4));
  for (std::size_t k = 0; k < 6; ++k) {
    const double bound = k > 2 ? 0.5 : k == 1 ? M_PI / 2 : M_PI;
    const auto word = emtr::draw(settings.seed, 12, Stream::Alpha, 4, k);
    EXPECT_DOUBLE_EQ(poses().position(4)[k], -bound + 2 * bound * emtr::uniform(word[2]));
  }
}

}  // namespace
