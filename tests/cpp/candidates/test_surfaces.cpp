#include <gtest/gtest.h>

#include <stdexcept>

#include "scene.h"

namespace {

using emtr::Surfaces;
using emtr_test::Scene;

const Scene& scene() {
  static const Scene one(32);
  return one;
}

TEST(Surfaces, ACloudTakesItsNormalsFromItsFeatures) {
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

TEST(Surfaces, WithoutViewpointsTheScoreIsTheFit) {
  const Surfaces both(scene().source, scene().target, {}, {}, emtr::select_kernels());
  EXPECT_EQ(both.source().points.x, scene().source.points.x);
  EXPECT_EQ(both.target().normals.y.size(), scene().target.points.size());
  emtr::Ranking::Scratch scratch;
  const auto truth = both.ranking().evaluate(scene().truth, scratch);
  EXPECT_GT(truth.score, 0.4);
  EXPECT_EQ(truth.score, truth.fit.chf);
  EXPECT_EQ(truth.violation, 0);
}

TEST(Surfaces, TheQuickLookIsReadyAndCloseToTheWholeOne) {
  const Surfaces both(scene().source, scene().target, {}, {}, emtr::select_kernels());
  emtr::Fit::Scratch scratch;
  const emtr::Fit& fit = both.ranking().fit();
  const double quick = fit.evaluate(scene().truth, Surfaces::kQuickStep, scratch).chf;
  EXPECT_NEAR(quick, fit.evaluate(scene().truth, scratch).chf, 0.1);
  const double wrong =
      fit.evaluate(scene().off({0, 90, 0}, {0, 0, 0}), Surfaces::kQuickStep, scratch).chf;
  EXPECT_LT(wrong, quick - 0.2);
}

TEST(Surfaces, TheirPolishGoesToTheTruthFromAFewDegrees) {
  const Surfaces both(scene().source, scene().target, {}, {}, emtr::select_kernels());
  emtr::LocalPolish::Scratch scratch;
  const auto end = both.polish()(scene().off({0, 5, 0}, {0.03, 0, 0}), nullptr, scratch);
  EXPECT_NE(end.end, emtr::PolishEnd::TooFewInliers);
  EXPECT_LT(emtr_test::degrees_between(end.pose, scene().truth), 0.7);
  EXPECT_LT(emtr_test::shift_between(end.pose, scene().truth), 0.01);
}

TEST(Surfaces, GivenViewpointsMakeTheSidesCount) {
  const auto at = [&](const emtr_test::Vector& sensor, const double* center, double sign) {
    emtr::Viewpoint v;
    for (std::size_t a = 0; a < 3; ++a)
      v.at[a] = sign * (sensor[a] - center[a]) / scene().normalised.frame.scale;
    return v;
  };
  const emtr::Frame& frame = scene().normalised.frame;
  const auto& kernels = emtr::select_kernels();
  const auto from_source = emtr::given_viewpoint(
      scene().source, at(scene().sensor_source(), frame.center_source, 1), kernels);
  const auto score = [&](double sign) {
    const auto from_target = emtr::given_viewpoint(
        scene().target, at(scene().sensor_target(), frame.center_target, sign), kernels);
    const Surfaces both(scene().source, scene().target, from_source, from_target, kernels);
    emtr::Ranking::Scratch scratch;
    const auto value = both.ranking().evaluate(scene().truth, scratch);
    EXPECT_EQ(value.score, value.fit.same_side - 2 * value.violation);
    return value.score;
  };
  EXPECT_GT(score(1), 0.3);
  EXPECT_LT(score(-1), 0.1);  // as if the target were seen from within
}

TEST(Surfaces, RefuseLeavesThatDiffer) {
  emtr::Surface coarse = scene().target;
  coarse.leaf *= 2;
  EXPECT_THROW(Surfaces(scene().source, coarse, {}, {}, emtr::select_kernels()),
               std::invalid_argument);
}

}  // namespace
