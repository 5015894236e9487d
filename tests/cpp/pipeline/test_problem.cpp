#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "support/clouds.h"
#include "support/problems.h"
#include "util/error.h"

namespace {

TEST(Problem, RegistersWhateverThePoseAndTheUnit) {
  for (const std::uint64_t seed : {1u, 2u, 3u})
    for (const double unit : {1e-3, 1.0, 1e3}) {
      const emtr_test::Pair pair(seed, 5000, unit);
      const auto problem =
          emtr_test::problem_of(pair.source(), pair.target(), emtr::preset("paper"));
      const auto result = emtr_test::solve(*problem);
      EXPECT_TRUE(result->registered) << seed << ' ' << unit;
      EXPECT_LT(pair.error(result->transformation), 0.05) << seed << ' ' << unit;
    }
}

TEST(Problem, SolvesAgainToTheSameBits) {
  const emtr_test::Pair pair(4, 5000);
  const auto problem = emtr_test::problem_of(pair.source(), pair.target(), emtr::preset("paper"));
  const auto a = emtr_test::solve(*problem), b = emtr_test::solve(*problem);
  EXPECT_TRUE(std::equal(a->transformation, a->transformation + 16, b->transformation));
  EXPECT_EQ(a->alpha, b->alpha);
  EXPECT_EQ(a->beta, b->beta);
}

TEST(Problem, AllNeighborStructuresGiveTheSameBits) {
  const emtr_test::Pair pair(5, 3000);
  emtr::Settings settings = emtr::preset("paper");
  settings.iterations = 5;
  const auto solve = [&](emtr_neighbors kind) {
    settings.neighbors = kind;
    return emtr_test::solve(*emtr_test::problem_of(pair.source(), pair.target(), settings));
  };
  const auto grid = solve(EMTR_NEIGHBORS_GRID);
  for (const emtr_neighbors kind : {EMTR_NEIGHBORS_KDTREE, EMTR_NEIGHBORS_BRUTE_FORCE}) {
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
    const auto problem =
        emtr_test::problem_of(pair.source(), pair.target(), emtr::preset("paper"), at);
    EXPECT_EQ(problem->stopped, stop != "evolution" && stop != "verdict");
    const auto result = emtr_test::solve(*problem, at);
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
  const auto problem = emtr_test::problem_of(a.source(), target, emtr::preset("paper"));
  EXPECT_FALSE(emtr_test::solve(*problem)->registered);
}

TEST(Problem, FeaturesAreOfTheBackendThatTheSettingNames) {
  const emtr_test::Pair pair(10, 4000);
  for (const auto backend : {emtr::FeatureBackend::Pcl, emtr::FeatureBackend::Simd}) {
    emtr::Settings settings = emtr::preset("paper");
    EXPECT_EQ(settings.features, EMTR_FEATURES_PCL);
    emtr::set(settings, "features", static_cast<double>(backend));
    const auto problem = emtr_test::problem_of(pair.source(), pair.target(), settings);
    const double leaf = problem->downsampled.leaf_dense;
    emtr::FeatureDefinition definition;
    definition.normal_radius = 2 * leaf;
    definition.feature_radius = 5 * leaf;
    definition.backend = backend;
    const auto expected =
        emtr::describe(problem->downsampled.source_dense, definition, problem->kernels, 1);
    EXPECT_EQ(0, std::memcmp(problem->source_features->descriptors.data(),
                             expected.descriptors.data(), 4 * expected.descriptors.size()));
    EXPECT_TRUE(emtr_test::solve(*problem)->registered);
  }
}

TEST(Problem, NormalsFaceTheSensorsWhereBothAreGiven) {
  const emtr_test::Pair pair(6, 5000);
  emtr::Settings settings = emtr::preset("default");
  const auto made = [&] { return emtr_test::problem_of(pair.source(), pair.target(), settings); };
  const auto shares = [](const emtr::Problem& problem) {  // of normals that look along +z
    std::size_t up = 0, all = 0;
    for (std::size_t i = 2; i < problem.target_features->normals.size(); i += 3) {
      const float z = problem.target_features->normals[i];
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
  const auto p = emtr_test::problem_of(pair.source(), pair.target(), settings);
  EXPECT_EQ(&p->kernels, &emtr::select_kernels());
  EXPECT_EQ(p->pair.preprocessed_source->count, 3000u);
  EXPECT_EQ(p->source_features->normals.size(), 3 * p->downsampled.source_dense.size());
  EXPECT_EQ(p->target_features->descriptors.size(),
            emtr::kFeatureSize * p->downsampled.target_dense.size());
  ASSERT_GT(p->correspondences.size(), 10u);
  for (const emtr::Correspondence& c : p->correspondences) {
    EXPECT_LT(static_cast<std::size_t>(c.source), p->downsampled.source_dense.size());
    EXPECT_LT(static_cast<std::size_t>(c.target), p->downsampled.target_dense.size());
  }
  ASSERT_FALSE(p->seeds.empty());
  const emtr::Rigid truth = p->pair.normalization.to_normalized(emtr::from_matrix(pair.pose()));
  EXPECT_LT(emtr::rotation_distance(p->seeds.front().pose.R, truth.R), 0.1);
  EXPECT_GT(p->tau, 0);
  ASSERT_TRUE(p->surfaces);
  EXPECT_EQ(p->surfaces->source().points.x, p->downsampled.source_dense.x);
  EXPECT_EQ(p->surfaces->target().leaf, p->downsampled.leaf_dense);
}

TEST(Problem, MakesOnlyWhatTheSettingsAskFor) {
  const emtr_test::Pair pair(11, 2000);
  emtr::Settings settings = emtr::preset("paper");
  const auto neither = emtr_test::problem_of(pair.source(), pair.target(), settings);
  EXPECT_TRUE(neither->seeds.empty());
  EXPECT_FALSE(neither->surfaces);
  settings.seeds = 20;  // for the swarm alone
  const auto seeds = emtr_test::problem_of(pair.source(), pair.target(), settings);
  EXPECT_FALSE(seeds->seeds.empty());
  EXPECT_LE(seeds->seeds.size(), 20u);
  EXPECT_FALSE(seeds->surfaces);
  settings.seeds = 0;
  settings.candidates = 5;  // of the swarm alone
  const auto candidates = emtr_test::problem_of(pair.source(), pair.target(), settings);
  EXPECT_TRUE(candidates->seeds.empty());
  EXPECT_TRUE(candidates->surfaces);
  const auto result = emtr_test::solve(*candidates);
  EXPECT_GT(result->candidates, 0u);
  EXPECT_LT(pair.error(result->transformation), 0.05);
}

TEST(Problem, PreprocessedCloudsGiveTheSameBits) {
  const emtr_test::Pair pair(12, 3000);
  const emtr::Settings settings = emtr::preset("default");
  const auto preprocessed = [](const emtr_cloud& cloud, const char* name) {
    return std::make_shared<const emtr::PreprocessedCloud>(cloud, name, 1);
  };
  const auto once = emtr_test::problem_of(pair.source(), pair.target(), settings);
  const auto again = emtr_test::problem_of(preprocessed(pair.source(), "a"),
                                           preprocessed(pair.target(), "b"), settings, nullptr);
  const auto a = emtr_test::solve(*once), b = emtr_test::solve(*again);
  EXPECT_TRUE(std::equal(a->transformation, a->transformation + 16, b->transformation));
  EXPECT_EQ(a->beta, b->beta);
  EXPECT_EQ(a->confidence, b->confidence);
}

TEST(Problem, RefusesBadSettings) {
  const emtr_test::Pair pair(9, 1000);
  emtr::Settings settings = emtr::preset("paper");
  settings.population = 1;
  EXPECT_THROW(emtr_test::problem_of(pair.source(), pair.target(), settings), emtr::Error);
}

}  // namespace
