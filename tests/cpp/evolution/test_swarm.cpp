#include <gtest/gtest.h>

#include <cmath>

#include "evolution/swarm.h"

namespace {

using emtr::Gene;
using emtr::Settings;
using emtr::Stream;
using emtr::Swarm;

void evaluate_sphere(Swarm& swarm, double shift) {
  for (std::size_t i = 0; i < swarm.size(); ++i) {
    double sum = 0;
    for (std::size_t k = 0; k < swarm.dimensions(); ++k)
      sum += std::pow(swarm.position(i)[k] - shift, 2);
    swarm.fitness()[i] = sum;
  }
}

TEST(Swarm, StartsInsideItsRanges) {
  const Swarm swarm(emtr::pose_genes(0.5), emtr::preset("paper"), Stream::Alpha);
  const double bounds[6] = {M_PI, M_PI / 2, M_PI, 0.5, 0.5, 0.5};
  double largest[6] = {};
  for (std::size_t i = 0; i < swarm.size(); ++i)
    for (std::size_t k = 0; k < 6; ++k) {
      EXPECT_LE(std::abs(swarm.position(i)[k]), bounds[k]);
      largest[k] = std::max(largest[k], std::abs(swarm.position(i)[k]));
    }
  for (std::size_t k = 0; k < 6; ++k) EXPECT_GT(largest[k], 0.7 * bounds[k]);
}

TEST(Swarm, FindsTheMinimumOfASphere) {
  const Settings settings = emtr::preset("paper");
  Swarm swarm(std::vector<Gene>(4, {-5, 5, false}), settings, Stream::Alpha);
  for (int it = 0; it < settings.iterations; ++it) {
    evaluate_sphere(swarm, 1.5);
    swarm.update_bests();
    const double done = static_cast<double>(it) / settings.iterations;
    swarm.move(it, 0.9 - 0.5 * done, swarm.gbest_position());
  }
  EXPECT_LT(swarm.gbest_fitness(), 1e-4);
}

TEST(Swarm, BestsNeverGetWorseAndGbestIsTheBest) {
  Swarm swarm(std::vector<Gene>(3, {-5, 5, false}), emtr::preset("paper"), Stream::Beta);
  std::vector<double> last(swarm.size(), HUGE_VAL);
  for (int it = 0; it < 30; ++it) {
    evaluate_sphere(swarm, 0);
    const std::vector<double> before(swarm.gbest_position(), swarm.gbest_position() + 3);
    const bool moved = swarm.update_bests();
    const std::vector<double> after(swarm.gbest_position(), swarm.gbest_position() + 3);
    EXPECT_EQ(moved, it == 0 || before != after);
    for (std::size_t i = 0; i < swarm.size(); ++i) {
      EXPECT_LE(swarm.best_fitness(i), last[i]);
      EXPECT_LE(swarm.gbest_fitness(), swarm.best_fitness(i));
      last[i] = swarm.best_fitness(i);
    }
    swarm.move(it, 0.9, swarm.gbest_position());
  }
}

TEST(Swarm, MoveIsTheEquationOfPso) {
  Settings settings = emtr::preset("paper");
  settings.velocity_limit = 1;
  settings.population = 2;
  Swarm swarm(std::vector<Gene>(1, {-100, 100, false}), settings, Stream::Alpha);
  evaluate_sphere(swarm, 0);
  swarm.update_bests();
  const double x0 = swarm.position(0)[0];
  const double v0 = 200 * (2 * emtr::uniform(emtr::draw(0, 0, Stream::Alpha, 0, 0)[1]) - 1);
  const double guide = 3;
  swarm.move(4, 0.01, &guide);
  const auto word = emtr::draw(0, 5, Stream::Alpha, 0, 0);
  const double v = 0.01 * v0 + 1.49445 * emtr::uniform(word[0]) * (x0 - x0) +
                   1.49445 * emtr::uniform(word[1]) * (guide - x0);
  EXPECT_NEAR(swarm.position(0)[0], x0 + v, 1e-10);
}

TEST(Swarm, WallsStopAndAnglesFlyOn) {
  Settings settings = emtr::preset("paper");
  Swarm swarm({{-1, 1, true}, {-1, 1, false}}, settings, Stream::Alpha);
  evaluate_sphere(swarm, 0);
  swarm.update_bests();
  const double guide[2] = {50, 50};
  double farthest = 0;
  for (int it = 0; it < 10; ++it) {
    swarm.move(it, 0.9, guide);
    for (std::size_t i = 0; i < swarm.size(); ++i) {
      EXPECT_LE(std::abs(swarm.position(i)[0]), 1);
      farthest = std::max(farthest, swarm.position(i)[1]);
    }
  }
  EXPECT_GT(farthest, 3);
}

TEST(Swarm, LimitsItsSteps) {
  Settings settings = emtr::preset("paper");
  settings.velocity_limit = 0.1;
  Swarm swarm(std::vector<Gene>(1, {-1, 1, false}), settings, Stream::Alpha);
  evaluate_sphere(swarm, 0);
  swarm.update_bests();
  const double guide = 1000;
  for (std::size_t i = 0; i < swarm.size(); ++i) {
    Swarm copy = swarm;
    copy.move(0, 0.9, &guide);
    EXPECT_NEAR(copy.position(i)[0] - swarm.position(i)[0], 0.2, 1e-12);
  }
}

}  // namespace
