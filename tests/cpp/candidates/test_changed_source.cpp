#include <gtest/gtest.h>

#include "candidates/changed_source.h"
#include "candidates/scene.h"

namespace {

using emtr::Surface;
using emtr::SurfacePair;

const emtr::Kernels& kernels() { return emtr::select_kernels(); }

Surface mirrored(Surface surface) {
  for (float& y : surface.points.y) y = -y;
  for (float& y : surface.normals.y) y = -y;
  return surface;
}

double score(const SurfacePair& surfaces) {
  emtr::Ranking::Scratch scratch;
  return surfaces.ranking().evaluate({}, scratch).score;
}

TEST(ChangedSource, AMirrorImageIsFoundByItsScore) {
  const Surface source = mirrored(emtr_test::lumpy_ball(4000, 3, 0.04)),
                target = emtr_test::lumpy_ball(4000, 2, 0.04);
  const SurfacePair surfaces(source, target, {}, {}, kernels());
  EXPECT_GT(emtr::mirrored_score(surfaces, {}, kernels()), 1.3 * score(surfaces));
}

TEST(ChangedSource, OfASceneWithoutSymmetryTheMirrorImageIsNotBetter) {
  const emtr_test::Scene scene(32);
  const SurfacePair surfaces(scene.source, scene.target, {}, {}, kernels());
  emtr::Ranking::Scratch scratch;
  EXPECT_LT(emtr::mirrored_score(surfaces, scene.truth, kernels()),
            0.5 * surfaces.ranking().evaluate(scene.truth, scratch).score);
}

class Scale : public testing::TestWithParam<double> {};

TEST_P(Scale, IsFoundWhereTheSourceHasAnother) {
  const emtr_test::Scene scene(32);
  Surface source = scene.source;
  for (auto* axis : {&source.points.x, &source.points.y, &source.points.z})
    for (float& v : *axis) v *= static_cast<float>(GetParam());
  const SurfacePair surfaces(source, scene.target, {}, {}, kernels());
  emtr::Ranking::Scratch scratch;
  const emtr::Rescaled found = emtr::best_scale(surfaces, scene.truth, kernels());
  EXPECT_NEAR(found.factor, 1 / GetParam(), 0.01);
  EXPECT_GT(found.score, 1.15 * surfaces.ranking().evaluate(scene.truth, scratch).score + 0.02);
}
INSTANTIATE_TEST_SUITE_P(Factors, Scale, testing::Values(0.9, 1.1));

TEST(ChangedSource, TheScaleOfARightPairIsOne) {
  const emtr_test::Scene scene(32);
  const SurfacePair surfaces(scene.source, scene.target, {}, {}, kernels());
  EXPECT_EQ(emtr::best_scale(surfaces, scene.truth, kernels()).factor, 1);
}

TEST(ChangedSource, APlaneHasNoScaleToBeFound) {
  Surface plane;
  plane.leaf = 0.05;
  for (int i = -15; i <= 15; ++i)
    for (int j = -15; j <= 15; ++j) emtr_test::push(plane, {0.05 * i, 0.05 * j, 0}, {0, 0, 1});
  const SurfacePair surfaces(plane, plane, {}, {}, kernels());
  EXPECT_EQ(emtr::best_scale(surfaces, {}, kernels()).factor, 1);
}

}  // namespace
