#include <gtest/gtest.h>

#include <cmath>

#include "preprocessing/normalization.h"
#include "refinement/refiner.h"
#include "refinement/shapes.h"
#include "refinement/similarity_refinement.h"

namespace {

using emtr::LocalRefinementSettings;
using emtr::Similarity;
using emtr::SimilarityFit;

constexpr double kLeaf = 0.03;

/// Refines one draw of a shape to another, from a start that is `off` in scale.
SimilarityFit fit(const emtr::Cloud& source, const emtr::Cloud& target, double off,
                  const emtr::Rigid& pose = {}) {
  const emtr_test::Refiner surfaces(emtr::downsample_surface(source, kLeaf),
                                    emtr::downsample_surface(target, kLeaf),
                                    LocalRefinementSettings());
  const emtr::SimilarityRefinement refinement(surfaces.source, surfaces.target,
                                              *surfaces.near_source, *surfaces.near_target,
                                              LocalRefinementSettings(), emtr::select_kernels());
  return refinement({off, pose}, nullptr);
}

emtr::Cloud room(
    std::uint64_t seed) {  // two walls and a floor, which meet in one corner, and a box
  return emtr_test::Draw(seed).cloud(20000, 1e-3, [](emtr_test::Draw& d) {
    const double u = d.uniform(0, 1), v = d.uniform(0, 1);
    const auto side = static_cast<int>(d.uniform(0, 6));
    if (side == 0) return Eigen::Vector3d(u, v, 0);
    if (side == 1) return Eigen::Vector3d(u, 0, v);
    if (side == 2) return Eigen::Vector3d(0, u, v);
    if (side == 3) return Eigen::Vector3d(0.4 + 0.2 * u, 0.4 + 0.2 * v, 0.2);
    if (side == 4) return Eigen::Vector3d(0.4 + 0.2 * u, 0.4, 0.2 * v);
    return Eigen::Vector3d(0.4, 0.4 + 0.2 * u, 0.2 * v);
  });
}

TEST(SimilarityRefinement, FindsScaleAndPoseTogether) {
  for (const double scale : {0.95, 1.0, 1.05}) {
    const emtr::Rigid off = emtr_test::motion({0.5, -0.8, 0.4}, {0.01, -0.01, 0.008});
    const SimilarityFit out = fit(room(1), emtr::scale_cloud(room(2), scale), 1, off);
    ASSERT_TRUE(out.succeeded);
    EXPECT_NEAR(out.similarity.scale, scale, 5e-3);
    EXPECT_LT(emtr_test::degrees_between(out.similarity.pose, emtr::Rigid()), 0.1);
    EXPECT_LT(out.similarity.pose.t.norm(), 2e-3);
    EXPECT_GT(out.scale_constraint, emtr::kUnconstrainedScale);
  }
}

TEST(SimilarityRefinement, ASphereConstrainsTheScaleFully) {
  const SimilarityFit out =
      fit(emtr_test::sphere(1, 20000, 1e-3), emtr_test::sphere(2, 20000, 1e-3), 1.03);
  ASSERT_TRUE(out.succeeded);
  EXPECT_NEAR(out.similarity.scale, 1, 2e-3);
  EXPECT_GT(out.scale_constraint, 0.9);
}

TEST(SimilarityRefinement, WhatIsSimilarToItselfLeavesTheScaleWhereItIs) {
  const auto corner = [](std::uint64_t seed) {
    return emtr_test::Draw(seed).cloud(20000, 1e-3, [](emtr_test::Draw& d) {
      const double u = d.uniform(0, 1), v = d.uniform(0, 1);
      const auto side = static_cast<int>(d.uniform(0, 3));
      return side == 0   ? Eigen::Vector3d(u, v, 0)
             : side == 1 ? Eigen::Vector3d(u, 0, v)
                         : Eigen::Vector3d(0, u, v);
    });
  };
  const auto cone = [](std::uint64_t seed) {
    return emtr_test::Draw(seed).cloud(20000, 1e-3, [](emtr_test::Draw& d) {
      const double a = d.uniform(0, 2 * M_PI), h = std::sqrt(d.uniform(0.04, 1));
      return Eigen::Vector3d(0.6 * h * std::cos(a), 0.6 * h * std::sin(a), h);
    });
  };
  for (const auto& [source, target] :
       {std::pair(emtr_test::plane(1, 20000, 1e-3), emtr_test::plane(2, 20000, 1e-3)),
        std::pair(corner(1), corner(2)), std::pair(cone(1), cone(2))}) {
    const SimilarityFit out = fit(source, target, 0.97);
    ASSERT_TRUE(out.succeeded);
    EXPECT_LT(out.scale_constraint, emtr::kUnconstrainedScale);
    EXPECT_NEAR(out.similarity.scale, 0.97, 0.01);
  }
}

TEST(SimilarityRefinement, GivesUpWhereTooLittleIsNear) {
  const emtr::Rigid away = emtr_test::motion({0, 0, 0}, {5, 0, 0});
  const SimilarityFit out = fit(room(1), room(2), 1, away);
  EXPECT_FALSE(out.succeeded);
  EXPECT_EQ(out.similarity.scale, 1);
  EXPECT_EQ(out.similarity.pose.t, away.t);
}

}  // namespace
