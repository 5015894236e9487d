#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "refinement/shapes.h"
#include "support/clouds.h"
#include "verdict/overlap.h"

namespace {

using emtr::Cloud;
using emtr::Overlap;

constexpr double kLeaf = 0.05;

/// Points of z = height over [low, high] x [-0.7, 0.7], drawn anew for each seed.
Cloud sheet(std::uint64_t seed, double low, double high, double height = 0, double noise = 0) {
  const double wide = high - low;
  return emtr_test::Draw(seed).cloud(
      static_cast<std::size_t>(20000 * wide), noise, [=](emtr_test::Draw& d) {
        return Eigen::Vector3d(d.uniform(low, high), d.uniform(-0.7, 0.7), height);
      });
}

/// A preprocessed cloud without user-provided normals, as fine_surfaces() asks for.
emtr::PreprocessedCloudPtr preprocessed(const Cloud& cloud) {
  std::vector<float> rows;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    rows.insert(rows.end(), {cloud.x[i], cloud.y[i], cloud.z[i]});
  const emtr_cloud view{rows.data(), cloud.size(), 0, EMTR_FLOAT32};
  return std::make_shared<const emtr::PreprocessedCloud>(view, "", 1);
}

emtr::NormalizedPair pair_of(const Cloud& source, const Cloud& target) {
  emtr::NormalizedPair pair;
  pair.source = source;
  pair.target = target;
  pair.preprocessed_source = preprocessed(source);
  pair.preprocessed_target = preprocessed(target);
  return pair;
}

double surface_mismatch(const Cloud& source, const Cloud& target, const emtr::Rigid& pose = {}) {
  const emtr::Kernels& kernels = emtr::select_kernels();
  const emtr::NormalizedPair pair = pair_of(source, target);
  const emtr::FineSurfaces fine = emtr::fine_surfaces(pair, kLeaf, 1, kernels);
  return emtr::surface_mismatch(emtr::evaluate_overlap(pair, fine, pose, kernels), pair, fine,
                                kernels);
}

Overlap evaluate_overlap(const Cloud& source, const Cloud& target, const emtr::Rigid& pose = {},
                         const emtr::Kernels& kernels = emtr::select_kernels()) {
  const emtr::NormalizedPair pair = pair_of(source, target);
  return emtr::evaluate_overlap(pair, emtr::fine_surfaces(pair, kLeaf, 1, kernels), pose, kernels);
}

TEST(Overlap, OverlapIsTheShareThatLiesOnTheOther) {
  const Overlap a = evaluate_overlap(sheet(1, -0.6, 0.4), sheet(2, 0.0, 0.5));
  EXPECT_NEAR(a.overlap_source, 0.4, 0.05);  // and a leaf beyond the edge
  EXPECT_NEAR(a.overlap_target, 0.8, 0.09);
  const Overlap none = evaluate_overlap(sheet(1, -0.6, 0.4), sheet(2, -0.6, 0.4, 0.2));
  EXPECT_EQ(none.overlap_source, 0);
  EXPECT_EQ(none.overlap_target, 0);
  EXPECT_TRUE(std::isnan(none.rmse) && std::isnan(none.plane_rmse));
}

TEST(Overlap, PlaneResidualsAreTheNoiseAndPointResidualsTheSpacingToo) {
  for (const double noise : {0.001, 0.004}) {
    const Overlap a =
        evaluate_overlap(sheet(3, -0.5, 0.5, 0.02, noise), sheet(4, -0.5, 0.5, 0.02, noise));
    EXPECT_GT(a.overlap_source, 0.99);
    EXPECT_NEAR(a.plane_rmse, noise, 0.2 * noise);  // the target's is averaged over a cube
    EXPECT_GT(a.rmse, 0.25 * kLeaf);
    EXPECT_LT(a.rmse, 0.6 * kLeaf);
  }
  const Overlap off = evaluate_overlap(sheet(3, -0.5, 0.5, 0.03), sheet(4, -0.5, 0.5, 0.01));
  EXPECT_NEAR(off.plane_rmse, 0.02, 1e-4);
}

TEST(Overlap, MismatchTellsFlushSurfacesFromThoseThatCross) {
  for (const double noise : {0.001, 0.01}) {
    const Cloud still = sheet(11, -0.5, 0.5, 0.02, noise);
    EXPECT_NEAR(surface_mismatch(sheet(12, -0.5, 0.5, 0.02, noise), still), 0, 0.15) << noise;
  }
  const Cloud one = sheet(13, -0.5, 0.5), other = sheet(14, -0.5, 0.5);
  EXPECT_GT(surface_mismatch(one, other, emtr_test::motion({90, 0, 0}, {0, 0, 0})), 0.7);
  EXPECT_TRUE(std::isnan(surface_mismatch(one, sheet(14, -0.5, 0.5, 0.2))));
}

TEST(Overlap, IsTakenAtThePose) {
  const emtr::Rigid pose = emtr_test::motion({20, -30, 40}, {0.3, 0.2, -0.1});
  const Cloud target = sheet(5, -0.5, 0.5);
  Cloud source = target;
  const emtr::Rigid back = pose.inverse();
  for (std::size_t i = 0; i < source.size(); ++i) {
    const Eigen::Vector3d p(source.x[i], source.y[i], source.z[i]);
    const Eigen::Vector3d q = back.R * p + back.t;
    source.x[i] = static_cast<float>(q.x());
    source.y[i] = static_cast<float>(q.y());
    source.z[i] = static_cast<float>(q.z());
  }
  const Overlap a = evaluate_overlap(source, target, pose);
  EXPECT_GT(a.overlap_source, 0.99);
  EXPECT_GT(a.overlap_target, 0.99);
  EXPECT_LT(a.plane_rmse, 1e-5);
  EXPECT_LT(evaluate_overlap(source, target).overlap_source, 0.5);
}

TEST(Overlap, IsTheSameBitsForAllKernels) {
  const Cloud source = sheet(6, -0.6, 0.4, 0, 0.003), target = sheet(7, -0.1, 0.7, 0, 0.003);
  const emtr::Rigid pose = emtr_test::motion({1, 1, 0}, {0, 0, 0.001});
  const Overlap a = evaluate_overlap(source, target, pose);
  for (const emtr::Kernels* k : emtr_test::kernels_here()) {
    const Overlap b = evaluate_overlap(source, target, pose, *k);
    EXPECT_EQ(a.overlap_source, b.overlap_source) << k->name;
    EXPECT_EQ(a.overlap_target, b.overlap_target) << k->name;
    EXPECT_EQ(a.rmse, b.rmse) << k->name;
    EXPECT_EQ(a.plane_rmse, b.plane_rmse) << k->name;
  }
}

}  // namespace
