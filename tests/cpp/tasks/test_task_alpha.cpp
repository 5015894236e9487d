#include <gtest/gtest.h>

#include <cmath>

#include "geometry/euler.h"
#include "support/clouds.h"
#include "tasks/task_alpha.h"

namespace {

using emtr::Cloud;
using emtr::Rigid;

emtr::DownsampledClouds small_downsampled_clouds() {
  emtr::DownsampledClouds d;
  d.leaf_sparse = 0.2;
  d.leaf_dense = 0.1;
  d.source_sparse = emtr_test::uniform_cloud(40, 1);
  d.target_sparse = emtr_test::uniform_cloud(50, 2);
  d.source_dense = emtr_test::uniform_cloud(200, 3);
  d.target_dense = emtr_test::uniform_cloud(150, 4);
  return d;
}

emtr::TaskAlpha::DenseReferences dense(const emtr::DownsampledClouds& d) {
  return {d.source_dense, d.target_dense, 0};
}

std::unique_ptr<emtr::Neighbors> grid(const Cloud& cloud, float radius, std::size_t,
                                      emtr_resolution) {
  return emtr::make_candidate_grid(cloud, radius, radius, emtr::select_kernels());
}

Rigid pose() {
  const double particle[6] = {0.4, -0.3, 1.1, 0.1, -0.05, 0.2};
  return emtr::decode(particle);
}

/// Straight from the formula, in double, without a structure.
double oracle(const Cloud& from, const Cloud& to, const Rigid& T, double c) {
  double sum = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const double p[3] = {double{from.x[i]}, double{from.y[i]}, double{from.z[i]}};
    double y[3];
    for (int a = 0; a < 3; ++a)
      y[a] = T.R(a, 0) * p[0] + T.R(a, 1) * p[1] + T.R(a, 2) * p[2] + T.t[a];
    double nearest = HUGE_VAL;
    for (std::size_t k = 0; k < to.size(); ++k)
      nearest = std::min(nearest, std::hypot(y[0] - double{to.x[k]}, y[1] - double{to.y[k]},
                                             y[2] - double{to.z[k]}));
    sum += nearest <= c ? 1 - std::pow(1 - nearest * nearest / (c * c), 3) : 1;
  }
  return sum;
}

TEST(TaskAlpha, SparseStageIsTheSourceSum) {
  const emtr::DownsampledClouds d = small_downsampled_clouds();
  const emtr::TaskAlpha alpha(d, dense(d), emtr::preset("paper"), emtr::select_kernels(), grid);
  emtr::TaskAlpha::Scratch scratch;
  EXPECT_NEAR(alpha.evaluate(EMTR_RESOLUTION_SPARSE, pose(), scratch),
              oracle(d.source_sparse, d.target_sparse, pose(), 1.5 * 0.2), 1e-3);
  EXPECT_EQ(alpha.queries(EMTR_RESOLUTION_SPARSE), 40u);
}

TEST(TaskAlpha, EndsEarlyOnlyWhereItIsNotLess) {
  emtr::DownsampledClouds d = small_downsampled_clouds();
  d.source_dense = emtr_test::uniform_cloud(2000, 3);
  d.target_dense = emtr_test::uniform_cloud(1500, 4);
  const emtr::TaskAlpha alpha(d, dense(d), emtr::preset("paper"), emtr::select_kernels(), grid);
  emtr::TaskAlpha::Scratch scratch;
  for (const auto stage : {EMTR_RESOLUTION_SPARSE, EMTR_RESOLUTION_DENSE}) {
    const double whole = alpha.evaluate(stage, pose(), scratch);
    ASSERT_GT(whole, 1);
    for (const double share : {0.0, 0.1, 0.5, 0.9, 1.0})
      EXPECT_GE(alpha.evaluate(stage, pose(), share * whole, scratch), share * whole);
    if (stage == EMTR_RESOLUTION_DENSE) {
      EXPECT_LT(alpha.evaluate(stage, pose(), 0.1 * whole, scratch), whole);  // it did end
    }
    for (const double enough : {std::nextafter(whole, 1e9), 1.1 * whole, HUGE_VAL})
      EXPECT_EQ(alpha.evaluate(stage, pose(), enough, scratch), whole);
  }
}

TEST(TaskAlpha, DenseStageIsTheChamferSumOfBothDirections) {
  const emtr::DownsampledClouds d = small_downsampled_clouds();
  const emtr::TaskAlpha alpha(d, dense(d), emtr::preset("paper"), emtr::select_kernels(), grid);
  emtr::TaskAlpha::Scratch scratch;
  const double c = 0.5 * 0.1;
  EXPECT_NEAR(alpha.evaluate(EMTR_RESOLUTION_DENSE, pose(), scratch),
              oracle(d.source_dense, d.target_dense, pose(), c) +
                  oracle(d.target_dense, d.source_dense, pose().inverse(), c),
              1e-3);
  EXPECT_EQ(alpha.queries(EMTR_RESOLUTION_DENSE), 350u);
}

TEST(TaskAlpha, DenseStageFindsItsNeighborsInTheReferences) {
  const emtr::DownsampledClouds d = small_downsampled_clouds();
  const Cloud source = emtr_test::uniform_cloud(900, 5), target = emtr_test::uniform_cloud(800, 6);
  const emtr::TaskAlpha alpha(d, {source, target, 0}, emtr::preset("paper"), emtr::select_kernels(),
                              grid);
  const double c = alpha.scale(EMTR_RESOLUTION_DENSE),
               forward = oracle(d.source_dense, target, pose(), c),
               backward = oracle(d.target_dense, source, pose().inverse(), c);
  emtr::TaskAlpha::Scratch scratch;
  EXPECT_NEAR(alpha.evaluate(EMTR_RESOLUTION_DENSE, pose(), scratch), forward + backward, 1e-3);
  EXPECT_NEAR(alpha.residuals_source(pose()).rho_sum, forward, 1e-3);
  EXPECT_NEAR(alpha.residuals_target(pose()).rho_sum, backward, 1e-3);
  EXPECT_EQ(alpha.queries(EMTR_RESOLUTION_DENSE), 350u);
}

TEST(TaskAlpha, CIsNeverBelowTheLeastOfTheReferences) {
  const emtr::DownsampledClouds d = small_downsampled_clouds();
  const auto scale = [&](double least) {
    return emtr::TaskAlpha(d, {d.source_dense, d.target_dense, least}, emtr::preset("paper"),
                           emtr::select_kernels(), grid)
        .scale(EMTR_RESOLUTION_DENSE);
  };
  EXPECT_EQ(scale(0.9 * scale(0)), scale(0));
  EXPECT_EQ(scale(0.7), 0.7);
}

TEST(TaskAlpha, IsZeroWhereTheCloudsLieOnEachOther) {
  emtr::DownsampledClouds d = small_downsampled_clouds();
  d.target_dense = d.source_dense;
  const emtr::TaskAlpha alpha(d, dense(d), emtr::preset("paper"), emtr::select_kernels(), grid);
  emtr::TaskAlpha::Scratch scratch;
  EXPECT_EQ(alpha.evaluate(EMTR_RESOLUTION_DENSE, Rigid{}, scratch), 0);
}

TEST(TaskAlpha, IsWorstFarAway) {
  const emtr::DownsampledClouds d = small_downsampled_clouds();
  const emtr::TaskAlpha alpha(d, dense(d), emtr::preset("paper"), emtr::select_kernels(), grid);
  emtr::TaskAlpha::Scratch scratch;
  Rigid far;
  far.t[0] = 100;
  EXPECT_EQ(alpha.evaluate(EMTR_RESOLUTION_DENSE, far, scratch),
            alpha.worst(EMTR_RESOLUTION_DENSE));
  EXPECT_EQ(alpha.evaluate(EMTR_RESOLUTION_SPARSE, far, scratch),
            alpha.worst(EMTR_RESOLUTION_SPARSE));
}

}  // namespace
