#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "error.h"
#include "problem.h"
#include "support/clouds.h"

namespace {

TEST(Problem, RegistersWhateverThePoseAndTheUnit) {
  for (const std::uint64_t seed : {1, 2, 3})
    for (const double unit : {1e-3, 1.0, 1e3}) {
      const emtr_test::Pair pair(seed, 5000, unit);
      const emtr::Problem problem(pair.source(), pair.target(), emtr::preset("paper"), nullptr);
      const auto result = problem.solve(nullptr);
      EXPECT_TRUE(result->registered) << seed << ' ' << unit;
      EXPECT_LT(pair.error(result->transformation), 0.05) << seed << ' ' << unit;
    }
}

TEST(Problem, SolvesAgainToTheSameBits) {
  const emtr_test::Pair pair(4, 5000);
  const emtr::Problem problem(pair.source(), pair.target(), emtr::preset("paper"), nullptr);
  const auto a = problem.solve(nullptr), b = problem.solve(nullptr);
  EXPECT_TRUE(std::equal(a->transformation, a->transformation + 16, b->transformation));
  EXPECT_EQ(a->alpha, b->alpha);
  EXPECT_EQ(a->beta, b->beta);
}

TEST(Problem, AllNeighbourStructuresGiveTheSameBits) {
  const emtr_test::Pair pair(5, 3000);
  emtr::Settings settings = emtr::preset("paper");
  settings.iterations = 20;
  const auto solve = [&](int kind) {
    settings.neighbors = kind;
    return emtr::Problem(pair.source(), pair.target(), settings, nullptr).solve(nullptr);
  };
  const auto grid = solve(0);
  for (const int kind : {1, 2}) {
    const auto other = solve(kind);
    EXPECT_EQ(grid->alpha, other->alpha);
    EXPECT_TRUE(std::equal(grid->transformation, grid->transformation + 16, other->transformation));
  }
}

TEST(Problem, CanBeStoppedBeforeEveryStage) {
  const emtr_test::Pair pair(6, 3000);
  for (const std::string stop :
       {"frame", "densities", "features", "matching", "evolution", "verdict"}) {
    const auto at = [&](const emtr_progress& p) { return stop == p.stage; };
    const emtr::Problem problem(pair.source(), pair.target(), emtr::preset("paper"), at);
    EXPECT_EQ(problem.stopped(), stop != "evolution" && stop != "verdict");
    const auto result = problem.solve(at);
    EXPECT_FALSE(result->registered);
    EXPECT_EQ(result->reason, EMTR_REASON_INTERRUPTED);
    EXPECT_EQ(std::isnan(result->transformation[0]), stop != "verdict") << stop;
  }
}

TEST(Problem, UnrelatedCloudsAreNotRegistered) {
  const emtr_test::Pair a(7, 4000), b(8, 4000);
  const auto flat = emtr_test::uniform_cloud(4000, 3, 1, 0.02f);
  std::vector<float> plate;
  for (std::size_t i = 0; i < flat.size(); ++i)
    plate.insert(plate.end(), {flat.x[i], flat.y[i], flat.z[i]});
  const emtr_cloud target{plate.data(), flat.size(), 0, EMTR_FLOAT32};
  const emtr::Problem problem(a.source(), target, emtr::preset("paper"), nullptr);
  EXPECT_FALSE(problem.solve(nullptr)->registered);
}

TEST(Problem, FeaturesAreOfTheBackendThatTheSettingNames) {
  const emtr_test::Pair pair(10, 4000);
  for (const auto backend : {emtr::FeatureBackend::Pcl, emtr::FeatureBackend::Simd}) {
    emtr::Settings settings = emtr::preset("paper");
    EXPECT_EQ(settings.features, 0);
    emtr::set(settings, "features", static_cast<double>(backend));
    const emtr::Problem problem(pair.source(), pair.target(), settings, nullptr);
    const double leaf = problem.densities.leaf_dense;
    emtr::FeatureDefinition definition;
    definition.normal_radius = 2 * leaf;
    definition.feature_radius = 5 * leaf;
    definition.backend = backend;
    const auto expected =
        emtr::describe(problem.densities.source_dense, definition, problem.kernels, 1);
    EXPECT_EQ(0, std::memcmp(problem.source_features.descriptors.data(),
                             expected.descriptors.data(), 4 * expected.descriptors.size()));
    EXPECT_TRUE(problem.solve(nullptr)->registered);
  }
}

TEST(Problem, RefusesBadSettings) {
  const emtr_test::Pair pair(9, 1000);
  emtr::Settings settings = emtr::preset("paper");
  settings.population = 1;
  EXPECT_THROW(emtr::Problem(pair.source(), pair.target(), settings, nullptr), emtr::Error);
}

}  // namespace
