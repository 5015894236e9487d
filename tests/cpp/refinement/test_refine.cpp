#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "ranking/surfaces.h"
#include "refinement/downsampled_surface.h"
#include "refinement/refine.h"
#include "refinement/shapes.h"
#include "support/clouds.h"

namespace {

using emtr::Refined;
using emtr_test::degrees_between;
using emtr_test::translation_between;

/// A pair in its normalized frame, and what refinement makes of a start some way from the truth.
struct Refinement {
  emtr_test::Pair pair;
  emtr::NormalizedPair normalized;
  emtr::Settings settings = emtr::preset("default");
  emtr::Rigid truth;

  explicit Refinement(std::uint64_t seed, std::size_t points = 5000)
      : pair(seed, points), normalized(emtr::normalize(pair.source(), pair.target(), 1)) {
    settings.threads = 1;
    truth = normalized.normalization.to_normalized(emtr::from_matrix(pair.pose()));
  }

  emtr::Rigid off(const Eigen::Vector3d& degrees, const Eigen::Vector3d& translation) const {
    return emtr_test::compose(emtr_test::motion(degrees, translation), truth);
  }
  emtr::FineSurfaces fine(const emtr::Kernels& kernels, double coarsest = 0.1) const {
    return emtr::fine_surfaces(normalized, settings.refine_leaf, coarsest, kernels);
  }
  Refined from(const emtr::Rigid& start,
               const emtr::Kernels& kernels = emtr::select_kernels()) const {
    return emtr::refine(fine(kernels), start, settings, kernels, nullptr);
  }
};

TEST(FineSurfaces, AreAsFineAsThePointsAllowAndNoCoarserThanThoseOfTheCandidates) {
  const emtr::Kernels& kernels = emtr::select_kernels();
  const double sparse = Refinement(40, 1500).fine(kernels).leaf();
  EXPECT_GT(sparse, 0.05);  // three points a cube
  EXPECT_EQ(Refinement(40, 1500).fine(kernels, 0.04).leaf(), 0.04);
  EXPECT_LT(Refinement(40, 60000).fine(kernels).leaf(), sparse / 3);
}

/// Counts the voxels by making the surfaces.
TEST(FineSurfaces, GrowByTheVoxelsThatHoldPointsHoweverManyThereAre) {
  const emtr::Kernels& kernels = emtr::select_kernels();
  const Refinement r(40, 20000);
  const auto points_per_voxel = [](const emtr::Cloud& cloud, double leaf) {
    return static_cast<double>(cloud.size()) /
           static_cast<double>(emtr::downsample_surface(cloud, leaf).points.size());
  };
  for (const double asked : {1e-3, 4e-3, 1e-2, 0.1}) {  // too many voxels for a bit each, and not
    double leaf = r.normalized.leaf_of_radii(asked);
    for (int attempt = 0; attempt < 4; ++attempt) {
      const double filling = std::min(points_per_voxel(r.normalized.source, leaf),
                                      points_per_voxel(r.normalized.target, leaf));
      if (filling >= 3) break;
      leaf = r.normalized.leaf(leaf * std::sqrt(1.1 * 3 / filling));
    }
    EXPECT_EQ(emtr::fine_surfaces(r.normalized, asked, 1, kernels).leaf(), leaf) << asked;
  }
}

TEST(Refine, MendsADegreeAndAHundredth) {
  for (const std::uint64_t seed : {41u, 42u, 43u}) {
    const Refinement r(seed);
    const emtr::Rigid start = r.off({0.6, -0.6, 0.5}, {0.006, -0.006, 0.005});
    ASSERT_GT(degrees_between(start, r.truth), 0.95);
    const Refined out = r.from(start);
    ASSERT_TRUE(out.succeeded);
    EXPECT_LT(degrees_between(out.pose, r.truth), 0.15) << seed;
    EXPECT_LT(translation_between(out.pose, r.truth), 0.002) << seed;
    EXPECT_GT(out.rmse, 0);
    EXPECT_LT(out.rmse, 0.01);  // noise of 0.002 radii, and thinning
  }
}

TEST(Refine, EndsInTheSamePlaceFromAllSides) {
  const Refinement r(44);
  const Refined a = r.from(r.off({1, 0, 0}, {0, 0.01, 0}));
  const Refined b = r.from(r.off({0, -1, 0.5}, {-0.01, 0, 0}));
  ASSERT_TRUE(a.succeeded && b.succeeded);
  EXPECT_LT(degrees_between(a.pose, b.pose), 0.05);
  EXPECT_LT(translation_between(a.pose, b.pose), 0.001);
}

TEST(Refine, SaysHowFirmlyThePoseIsConstrained) {
  const Refinement r(45);
  const Refined out = r.from(r.off({0.5, 0, 0}, {0, 0, 0.005}));
  ASSERT_TRUE(out.succeeded);
  EXPECT_EQ(out.hessian_spectrum.unconstrained, 0);
  EXPECT_GT(out.hessian_spectrum.eigenvalues[0], emtr::kUnconstrainedEigenvalue);
  using Matrix = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;
  const Eigen::Map<const Matrix> information(out.information);
  EXPECT_LT((information - information.transpose()).norm(), 1e-9 * information.norm());
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(information);
  EXPECT_GT(solver.eigenvalues()[0], 1e4);  // a standard deviation of a hundredth at the worst
}

TEST(Refine, AHopelessStartIsGivenBack) {
  const Refinement r(46);
  const emtr::Rigid start = r.off({0, 0, 0}, {3, 0, 0});  // nothing is near anything
  const Refined out = r.from(start);
  EXPECT_FALSE(out.succeeded);
  EXPECT_TRUE(start.R == out.pose.R);
  EXPECT_TRUE(start.t == out.pose.t);
}

TEST(Refine, NeverGoesToADifferentAnswer) {
  const Refinement r(47);
  int failed = 0;
  emtr_test::Draw draw(3);
  for (int i = 0; i < 12; ++i) {
    const emtr::Rigid start =
        r.off(draw.uniform(10, 60) * draw.direction(), draw.uniform(0, 0.3) * draw.direction());
    const Refined out = r.from(start);
    if (!out.succeeded) {
      ++failed;
      EXPECT_TRUE(start.R == out.pose.R);
      EXPECT_TRUE(start.t == out.pose.t);
    }
    EXPECT_LE(degrees_between(out.pose, start), 10);
    EXPECT_LE(translation_between(out.pose, start), 0.15);
  }
  EXPECT_GT(failed, 0);
}

/// Mean error in degrees that is left of one degree; all must have succeeded.
double mean_left(std::size_t points) {
  double sum = 0;
  constexpr int kPairs = 10;
  for (std::uint64_t seed = 0; seed < kPairs; ++seed) {
    const Refinement r(100 + seed, points);
    const Refined out = r.from(r.off({0.6, -0.6, 0.5}, {0.006, -0.006, 0.005}));
    EXPECT_TRUE(out.succeeded) << seed;
    EXPECT_LT(translation_between(out.pose, r.truth), 0.03) << seed;
    sum += degrees_between(out.pose, r.truth);
  }
  return sum / kPairs;
}

TEST(Refine, WorksOnSparseClouds) {
  // At the leaf asked for there would be a point a cube, and no normals. A pair of 300 points a
  // tenth of a radius apart holds a degree and no more.
  EXPECT_LT(mean_left(300), 1.2);
  EXPECT_LT(mean_left(500), 0.5);
  EXPECT_LT(mean_left(1000), 0.2);
}

TEST(Refine, ACoarserLeafIsUsedWhenAskedFor) {
  Refinement r(50);
  const emtr::Rigid start = r.off({0.5, 0.5, 0}, {0.01, 0, 0});
  const Refined fine = r.from(start);
  r.settings.refine_leaf = 0.15;
  const Refined coarse = r.from(start);
  ASSERT_TRUE(fine.succeeded && coarse.succeeded);
  EXPECT_GT(coarse.rmse, 1.5 * fine.rmse);
  EXPECT_LT(degrees_between(coarse.pose, r.truth), 2);
}

TEST(Refine, IsTheSameBitsForAnyThreadsAndKernels) {
  Refinement r(51, 8000);
  const emtr::Rigid start = r.off({1, 0, 0}, {0, 0.01, 0});
  const Refined one = r.from(start);
  const auto expect_same = [&](const Refined& other, const char* what) {
    EXPECT_TRUE(one.pose.R == other.pose.R) << what;
    EXPECT_TRUE(one.pose.t == other.pose.t) << what;
    EXPECT_TRUE(std::equal(one.information, one.information + 36, other.information)) << what;
    EXPECT_EQ(one.rmse, other.rmse) << what;
    for (int i = 0; i < 6; ++i)
      EXPECT_EQ(one.hessian_spectrum.eigenvalues[i], other.hessian_spectrum.eigenvalues[i]) << what;
  };
  for (const emtr::Kernels* k : emtr_test::kernels_here()) expect_same(r.from(start, *k), k->name);
  for (const int threads : {2, 3, 8}) {
    r.settings.threads = threads;
    expect_same(r.from(start), "threads");
  }
}

}  // namespace
