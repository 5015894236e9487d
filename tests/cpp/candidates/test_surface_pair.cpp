#include <gtest/gtest.h>

#include <stdexcept>

#include "candidates/scene.h"

namespace {

using emtr::SurfacePair;
using emtr_test::Scene;

const Scene& scene() {
  static const Scene one(32);
  return one;
}

TEST(SurfacePair, ACloudTakesItsNormalsFromItsFeatures) {
  const emtr::Cloud cloud = emtr_test::uniform_cloud(4, 1);
  emtr::Features features;
  for (int i = 0; i < 12; ++i) features.normals.push_back(static_cast<float>(i));
  features.normals[7] = std::nanf("");
  const emtr::Surface s = emtr::surface(cloud, features, 0.25);
  EXPECT_EQ(s.points.x, cloud.x);
  EXPECT_EQ(s.points.z, cloud.z);
  EXPECT_EQ(s.leaf, 0.25);
  EXPECT_EQ(s.normals.x, (std::vector<float>{0, 3, 6, 9}));
  EXPECT_EQ(s.normals.z, (std::vector<float>{2, 5, 8, 11}));
  EXPECT_EQ(s.normals.y[1], 4);
  EXPECT_TRUE(std::isnan(s.normals.y[2]));  // a point without a normal stays one
}

TEST(SurfacePair, WithoutViewpointsNothingIsViolated) {
  const SurfacePair both(scene().source, scene().target, {}, {}, emtr::select_kernels());
  EXPECT_EQ(both.source().points.x, scene().source.points.x);
  EXPECT_EQ(both.target().normals.y.size(), scene().target.points.size());
  emtr::Ranking::Scratch scratch;
  const auto truth = both.ranking().evaluate(scene().truth, scratch);
  EXPECT_GT(truth.score, 0.3);
  EXPECT_EQ(truth.violation, 0);
}

TEST(SurfacePair, TheQuickLookIsReadyAndCloseToTheWholeOne) {
  const SurfacePair both(scene().source, scene().target, {}, {}, emtr::select_kernels());
  emtr::SurfaceFit::Scratch scratch;
  const emtr::SurfaceFit& fit = both.ranking().fit();
  const double quick = fit.evaluate(scene().truth, SurfacePair::kQuickStep, scratch).score;
  EXPECT_NEAR(quick, fit.evaluate(scene().truth, scratch).score, 0.1);
  const double wrong =
      fit.evaluate(scene().off({0, 90, 0}, {0, 0, 0}), SurfacePair::kQuickStep, scratch).score;
  EXPECT_LT(wrong, quick - 0.2);
}

TEST(SurfacePair, TheirRefinementGoesToTheTruthFromAFewDegrees) {
  const SurfacePair both(scene().source, scene().target, {}, {}, emtr::select_kernels());
  emtr::LocalRefinement::Scratch scratch;
  const auto end = both.local_refinement()(scene().off({0, 5, 0}, {0.03, 0, 0}), nullptr, scratch);
  EXPECT_NE(end.end, emtr::Termination::TooFewInliers);
  EXPECT_LT(emtr_test::degrees_between(end.pose, scene().truth), 0.7);
  EXPECT_LT(emtr_test::translation_between(end.pose, scene().truth), 0.01);
}

TEST(SurfacePair, GivenViewpointsMakeTheSidesCount) {
  const auto at = [&](const emtr_test::Vector& sensor, const double* center, double sign) {
    emtr::Viewpoint v;
    for (std::size_t a = 0; a < 3; ++a)
      v.at[a] = sign * (sensor[a] - center[a]) / scene().normalized.normalization.scale;
    return v;
  };
  const emtr::Normalization& normalization = scene().normalized.normalization;
  const auto from_source = at(scene().sensor_source(), normalization.center_source, 1);
  const auto score = [&](double sign) {
    const auto from_target = at(scene().sensor_target(), normalization.center_target, sign);
    const SurfacePair both(scene().source, scene().target, from_source, from_target,
                           emtr::select_kernels());
    emtr::Ranking::Scratch scratch;
    const auto value = both.ranking().evaluate(scene().truth, scratch);
    return value.score;
  };
  EXPECT_GT(score(1), 0.3);
  EXPECT_LT(score(-1), 0.1);  // as if the target were seen from within
}

TEST(SurfacePair, RefuseLeavesThatDiffer) {
  emtr::Surface coarse = scene().target;
  coarse.leaf *= 2;
  EXPECT_THROW(SurfacePair(scene().source, coarse, {}, {}, emtr::select_kernels()),
               std::invalid_argument);
}

}  // namespace
