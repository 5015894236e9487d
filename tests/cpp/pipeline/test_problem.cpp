#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "util/error.h"
#include "pipeline/problem.h"
#include "support/clouds.h"

namespace {

TEST(Problem, RegistersWhateverThePoseAndTheUnit) {
  for (const std::uint64_t seed : {1u, 2u, 3u})
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

TEST(Problem, AllNeighborStructuresGiveTheSameBits) {
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
       {"normalization", "downsampling", "features", "matching", "evolution", "verdict"}) {
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
  const emtr_test::Pair a(7, 4000);
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
    const double leaf = problem.downsampled.leaf_dense;
    emtr::FeatureDefinition definition;
    definition.normal_radius = 2 * leaf;
    definition.feature_radius = 5 * leaf;
    definition.backend = backend;
    const auto expected =
        emtr::describe(problem.downsampled.source_dense, definition, problem.kernels, 1);
    EXPECT_EQ(0, std::memcmp(problem.source_features.descriptors.data(),
                             expected.descriptors.data(), 4 * expected.descriptors.size()));
    EXPECT_TRUE(problem.solve(nullptr)->registered);
  }
}

TEST(Problem, NormalsTurnToTheSensorsWhereBothAreGiven) {
  const emtr_test::Pair pair(6, 5000);
  emtr::Settings settings = emtr::preset("default");
  const auto made = [&] {
    return std::make_unique<emtr::Problem>(pair.source(), pair.target(), settings, nullptr);
  };
  const auto shares = [](const emtr::Problem& problem) {  // of normals that look along +z
    std::size_t up = 0, all = 0;
    for (std::size_t i = 2; i < problem.target_features.normals.size(); i += 3) {
      const float z = problem.target_features.normals[i];
      if (std::isnan(z) || std::abs(z) < 0.1f) continue;
      up += z > 0;
      ++all;
    }
    return static_cast<double>(up) / static_cast<double>(all);
  };
  EXPECT_LT(shares(*made()), 0.9);
  settings.has_viewpoint_target = 1;
  settings.viewpoint_target[2] = 1e5;
  EXPECT_LT(shares(*made()), 0.9);  // one alone would make two rules of one
  settings.has_viewpoint_source = 1;
  settings.viewpoint_source[2] = 1e5;
  EXPECT_GT(shares(*made()), 0.999);
  settings.free_space = 0;
  EXPECT_LT(shares(*made()), 0.9);
}

TEST(Problem, KeepsWhatEveryStageMade) {
  const emtr_test::Pair pair(11, 3000);
  const emtr::Settings settings = emtr::preset("default");
  const emtr::Problem p(pair.source(), pair.target(), settings, nullptr);
  EXPECT_EQ(&p.kernels, &emtr::select_kernels());
  EXPECT_EQ(p.points_source, 3000u);
  EXPECT_EQ(p.source_features.normals.size(), 3 * p.downsampled.source_dense.size());
  EXPECT_EQ(p.target_features.descriptors.size(),
            emtr::kFeatureSize * p.downsampled.target_dense.size());
  ASSERT_GT(p.correspondences.size(), 10u);
  for (const emtr::Correspondence& c : p.correspondences) {
    EXPECT_LT(static_cast<std::size_t>(c.source), p.downsampled.source_dense.size());
    EXPECT_LT(static_cast<std::size_t>(c.target), p.downsampled.target_dense.size());
  }
  ASSERT_FALSE(p.seeds.empty());
  const emtr::Rigid truth = p.normalization.to_normalized(emtr::from_matrix(pair.pose()));
  EXPECT_LT(emtr::rotation_distance(p.seeds.front().pose.R, truth.R), 0.1);
  EXPECT_GT(p.tau, 0);
  ASSERT_TRUE(p.surfaces);
  EXPECT_EQ(p.surfaces->source().points.x, p.downsampled.source_dense.x);
  EXPECT_EQ(p.surfaces->target().leaf, p.downsampled.leaf_dense);
}

TEST(Problem, MakesOnlyWhatTheSettingsAskFor) {
  const emtr_test::Pair pair(11, 2000);
  emtr::Settings settings = emtr::preset("paper");
  const emtr::Problem neither(pair.source(), pair.target(), settings, nullptr);
  EXPECT_TRUE(neither.seeds.empty());
  EXPECT_FALSE(neither.surfaces);
  settings.seeds = 20;  // for the swarm alone
  const emtr::Problem seeds(pair.source(), pair.target(), settings, nullptr);
  EXPECT_FALSE(seeds.seeds.empty());
  EXPECT_LE(seeds.seeds.size(), 20u);
  EXPECT_FALSE(seeds.surfaces);
  settings.seeds = 0;
  settings.candidates = 5;  // of the swarm alone
  const emtr::Problem candidates(pair.source(), pair.target(), settings, nullptr);
  EXPECT_TRUE(candidates.seeds.empty());
  EXPECT_TRUE(candidates.surfaces);
  const auto result = candidates.solve(nullptr);
  EXPECT_GT(result->candidates, 0u);
  EXPECT_LT(pair.error(result->transformation), 0.05);
}

TEST(Problem, OfPreparedCloudsGivesTheSameBits) {
  const emtr_test::Pair pair(12, 3000);
  const emtr::Settings settings = emtr::preset("default");
  const auto preprocessed = [](const emtr_cloud& cloud, const char* name) {
    return std::make_shared<const emtr::PreprocessedCloud>(cloud, name, 1);
  };
  const emtr::Problem once(pair.source(), pair.target(), settings, nullptr);
  const emtr::Problem again(preprocessed(pair.source(), "a"), preprocessed(pair.target(), "b"), settings,
                            nullptr);
  const auto a = once.solve(nullptr), b = again.solve(nullptr);
  EXPECT_TRUE(std::equal(a->transformation, a->transformation + 16, b->transformation));
  EXPECT_EQ(a->beta, b->beta);
  EXPECT_EQ(a->confidence, b->confidence);
}

TEST(Problem, RefusesBadSettings) {
  const emtr_test::Pair pair(9, 1000);
  emtr::Settings settings = emtr::preset("paper");
  settings.population = 1;
  EXPECT_THROW(emtr::Problem(pair.source(), pair.target(), settings, nullptr), emtr::Error);
}

}  // namespace
