#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "support/clouds.h"
#include "support/problems.h"

namespace {

emtr::PreprocessedCloudPtr preprocessed(const emtr_cloud& cloud) {
  return std::make_shared<const emtr::PreprocessedCloud>(cloud, "", 1);
}

/// Two clouds that serve one problem after the other.
class Remembered : public testing::Test {
 protected:
  void expect_same_bits_as_fresh(const emtr::Settings& settings) const {
    const auto fresh =
        emtr_test::solve(*emtr_test::problem_of(pair.source(), pair.target(), settings));
    const auto known = emtr_test::solve(*emtr_test::problem_of(source, target, settings));
    EXPECT_TRUE(
        std::equal(fresh->transformation, fresh->transformation + 16, known->transformation));
    EXPECT_EQ(fresh->fitness, known->fitness);
    EXPECT_EQ(fresh->alternative_count, known->alternative_count);
    EXPECT_EQ(fresh->overlap_source, known->overlap_source);
  }

  const emtr_test::Pair pair{21, 6000};
  const emtr::PreprocessedCloudPtr source = preprocessed(pair.source()),
                                   target = preprocessed(pair.target());
};

TEST_F(Remembered, TheSurfacesOfTheNextProblemAreThoseOfTheLast) {
  const emtr::Settings settings = emtr::preset("default");
  const auto first = emtr_test::problem_of(source, target, settings),
             next = emtr_test::problem_of(source, target, settings);
  EXPECT_EQ(&first->surfaces->source(), &next->surfaces->source());
  EXPECT_EQ(&first->surfaces->near_target(), &next->surfaces->near_target());
}

TEST_F(Remembered, BesideACloudOfLikeSizeToo) {
  const emtr::Settings settings = emtr::preset("default");
  emtr_cloud like = pair.target();
  like.count -= 60;
  const auto first = emtr_test::problem_of(source, target, settings);
  const auto next = emtr_test::problem_of(source, preprocessed(like), settings);
  ASSERT_EQ(first->pair.normalization.scale, next->pair.normalization.scale);
  ASSERT_EQ(first->downsampled.leaf_dense, next->downsampled.leaf_dense);
  EXPECT_EQ(&first->surfaces->source(), &next->surfaces->source());
}

TEST_F(Remembered, GivesTheBitsThatAreMadeAnew) {
  for (const char* name : {"default", "fast", "thorough", "paper", "default"}) {
    SCOPED_TRACE(name);
    expect_same_bits_as_fresh(emtr::preset(name));
  }
}

TEST_F(Remembered, WhatWasMadeByOtherSettingsDoesNotServe) {
  const emtr::Settings usual = emtr::preset("default");
  expect_same_bits_as_fresh(usual);
  const auto changed = [&](const char* name, double value) {
    emtr::Settings settings = usual;
    emtr::set(settings, name, value);
    SCOPED_TRACE(name);
    expect_same_bits_as_fresh(settings);
  };
  changed("dense_points", 5000);
  changed("normal_radius", 2.5);
  changed("feature_radius", 4);
  changed("features", EMTR_FEATURES_PCL);
  changed("distinctiveness", 0);
  changed("refine_leaf", 0.02);
  changed("leaf_ladder", 0);
  changed("fallback_search", EMTR_ALWAYS);
  emtr::Settings seen = usual;
  seen.has_viewpoint_source = seen.has_viewpoint_target = 1;
  seen.viewpoint_source[2] = seen.viewpoint_target[2] = 50;
  expect_same_bits_as_fresh(seen);
}

TEST_F(Remembered, NotByTheCloudAtAnotherScale) {
  const emtr::Settings settings = emtr::preset("default");
  const auto usual = emtr_test::problem_of(source, target, settings);
  const auto half = emtr_test::problem_of(source->rescaled(0.5), target, settings);
  const auto fresh = emtr_test::problem_of(preprocessed(pair.source())->rescaled(0.5),
                                           preprocessed(pair.target()), settings);
  EXPECT_NE(half->downsampled.source_dense.x, usual->downsampled.source_dense.x);
  EXPECT_EQ(half->downsampled.source_dense.x, fresh->downsampled.source_dense.x);
  EXPECT_EQ(half->source_features->normals.size(), fresh->source_features->normals.size());
}

TEST_F(Remembered, ALadderOfLeavesKeepsTheCounts) {
  emtr::Settings settings = emtr::preset("default");
  const auto rung = emtr_test::problem_of(source, target, settings);
  settings.leaf_ladder = 0;
  const auto exact = emtr_test::problem_of(source, target, settings);
  const auto points = [](const emtr::Problem& p) {
    return static_cast<double>(p.downsampled.source_dense.size() +
                               p.downsampled.target_dense.size());
  };
  EXPECT_NEAR(points(*rung) / points(*exact), 1, 0.12);
  EXPECT_EQ(exact->pair.normalization.scale, std::max(source->radius, target->radius));
  EXPECT_GE(rung->pair.normalization.scale, exact->pair.normalization.scale);
  EXPECT_LT(rung->pair.normalization.scale, 1.1 * exact->pair.normalization.scale);
}

}  // namespace
