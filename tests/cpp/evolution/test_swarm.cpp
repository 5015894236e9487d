#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "evolution/swarm.h"

namespace {

using emtr::Gene;
using emtr::RotationSteps;
using emtr::Settings;
using emtr::Stream;
using emtr::Swarm;

void evaluate_sphere(Swarm& swarm, double center) {
  for (std::size_t i = 0; i < swarm.size(); ++i) {
    double sum = 0;
    for (std::size_t k = 0; k < swarm.dimensions(); ++k)
      sum += std::pow(swarm.position(i)[k] - center, 2);
    swarm.fitness()[i] = sum;
  }
}

TEST(Swarm, StartsInsideItsRanges) {
  const Swarm swarm(emtr::pose_genes(0.5), emtr::preset("paper"), Stream::Alpha,
                    RotationSteps::Angles);
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
  Swarm swarm(std::vector<Gene>(4, {-5, 5, false}), settings, Stream::Alpha, RotationSteps::Angles);
  for (int it = 0; it < settings.iterations; ++it) {
    evaluate_sphere(swarm, 1.5);
    swarm.update_bests();
    const double done = static_cast<double>(it) / settings.iterations;
    swarm.move(it, 0.9 - 0.5 * done, swarm.gbest_position());
  }
  EXPECT_LT(swarm.gbest_fitness(), 1e-4);
}

TEST(Swarm, BestsNeverGetWorseAndGbestIsTheBest) {
  Swarm swarm(std::vector<Gene>(3, {-5, 5, false}), emtr::preset("paper"), Stream::Beta,
              RotationSteps::Angles);
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
  Swarm swarm(std::vector<Gene>(1, {-100, 100, false}), settings, Stream::Alpha,
              RotationSteps::Angles);
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
  Swarm swarm({{-1, 1, true}, {-1, 1, false}}, settings, Stream::Alpha, RotationSteps::Angles);
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
  Swarm swarm(std::vector<Gene>(1, {-1, 1, false}), settings, Stream::Alpha, RotationSteps::Angles);
  evaluate_sphere(swarm, 0);
  swarm.update_bests();
  const double guide = 1000;
  for (std::size_t i = 0; i < swarm.size(); ++i) {
    Swarm copy = swarm;
    copy.move(0, 0.9, &guide);
    EXPECT_NEAR(copy.position(i)[0] - swarm.position(i)[0], 0.2, 1e-12);
  }
}

TEST(Swarm, StepsByRotationVectorsAreTheEquationOfPsoInTheTangentSpace) {
  Settings settings = emtr::preset("paper");
  settings.population = 20;
  settings.velocity_limit = 0.1;
  Swarm swarm(emtr::pose_genes(0.5), settings, Stream::Alpha, RotationSteps::Vector);
  const double limit = 0.1 * 2 * M_PI;  // a rotation vector's range is 2 pi, for all three
  evaluate_sphere(swarm, 0);
  swarm.update_bests();
  // Away from its pbest, so that both pulls count: of two moves the second is looked at.
  const double guide[6] = {2, -1, 0.4, 0.1, 0.2, -0.3};
  double velocity[20][6];
  std::size_t free = 0;
  for (int it = 0; it < 2; ++it) {
    const Swarm before = swarm;
    swarm.move(it, 0.7, guide);
    for (std::size_t i = 0; i < swarm.size(); ++i) {
      double to_best[6], to_guide[6], step[6];
      emtr::rotation_between(before.position(i), before.best_position(i), to_best);
      emtr::rotation_between(before.position(i), guide, to_guide);
      emtr::rotation_between(before.position(i), swarm.position(i), step);
      for (std::size_t k = 3; k < 6; ++k) {
        to_best[k] = before.best_position(i)[k] - before.position(i)[k];
        to_guide[k] = guide[k] - before.position(i)[k];
        step[k] = swarm.position(i)[k] - before.position(i)[k];
      }
      for (std::size_t k = 0; k < 6; ++k) {
        const auto number = static_cast<std::uint64_t>(it);
        const auto word = emtr::draw(0, number + 1, Stream::Alpha, i, k);
        const double bound = k < 3 ? limit : 0.1;
        if (it == 0)
          velocity[i][k] =
              bound * (2 * emtr::uniform(emtr::draw(0, 0, Stream::Alpha, i, k)[1]) - 1);
        double& v = velocity[i][k];
        v = 0.7 * v + 1.49445 * emtr::uniform(word[0]) * to_best[k] +
            1.49445 * emtr::uniform(word[1]) * to_guide[k];
        free += std::abs(v) < bound;
        v = std::clamp(v, -bound, bound);
        if (std::abs(before.position(i)[k] + v) <= 0.5 || k < 3)
          EXPECT_NEAR(step[k], v, 1e-9) << it << ", " << i << ", " << k;
        else
          v = 0;  // stopped by the wall
      }
    }
  }
  EXPECT_GT(free, 40u);  // the limit did not hide the rest
}

TEST(Swarm, StepsByRotationVectorsTakeTheShortWay) {
  Settings settings = emtr::preset("paper");
  Swarm swarm(emtr::rotation_genes(), settings, Stream::Beta, RotationSteps::Vector);
  // A rotation by nearly pi, written in angles that differ by nearly 2 pi.
  const double target[3] = {M_PI - 0.02, 0.3, 0};
  for (int it = 0; it < settings.iterations; ++it) {
    for (std::size_t i = 0; i < swarm.size(); ++i) {
      double vector[3];
      emtr::rotation_between(swarm.position(i), target, vector);
      swarm.fitness()[i] = std::hypot(vector[0], vector[1], vector[2]);
    }
    swarm.update_bests();
    swarm.move(it, 0.9 - 0.5 * it / settings.iterations, swarm.gbest_position());
  }
  EXPECT_LT(swarm.gbest_fitness(), 1e-3);
}

}  // namespace
