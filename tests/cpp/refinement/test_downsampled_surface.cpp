#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "refinement/downsampled_surface.h"
#include "refinement/shapes.h"
#include "voxels/voxel_grid.h"

namespace {

using emtr::Cloud;
using emtr::downsample_surface;
using emtr::Surface;
using emtr_test::push;

std::vector<std::array<float, 3>> sorted(const Cloud& cloud) {
  std::vector<std::array<float, 3>> out;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    out.push_back({cloud.x[i], cloud.y[i], cloud.z[i]});
  std::sort(out.begin(), out.end());
  return out;
}

TEST(DownsampleSurface, HasThePointsOfTheVoxelGrid) {
  const Cloud cloud = emtr_test::uniform_cloud(4000, 3);
  for (const double leaf : {0.04, 0.11, 0.5}) {
    const auto ours = sorted(downsample_surface(cloud, leaf).points);
    const auto theirs = sorted(emtr::voxel_grid(cloud, static_cast<float>(leaf)));
    ASSERT_EQ(ours.size(), theirs.size());
    for (std::size_t i = 0; i < ours.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(ours[i][k], theirs[i][k], 2e-6f);
  }
}

TEST(DownsampleSurface, NormalsAreThoseOfTheCovarianceOfAllPointsInTheBallOfCubes) {
  const Cloud cloud = emtr_test::cube(5, 3000, 0.01);
  constexpr double leaf = 0.08, reach = 2.5;
  const Surface surface = downsample_surface(cloud, leaf, reach);
  const auto cube_of = [&](const Cloud& c, std::size_t i) {
    const float inverse = 1 / static_cast<float>(leaf);
    return Eigen::Vector3d(std::floor(c.x[i] * inverse), std::floor(c.y[i] * inverse),
                           std::floor(c.z[i] * inverse));
  };
  std::size_t compared = 0;
  for (std::size_t i = 0; i < surface.points.size(); i += 7) {
    std::vector<Eigen::Vector3d> near;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < cloud.size(); ++k)
      if ((cube_of(cloud, k) - cube_of(surface.points, i)).norm() <= reach) {
        near.emplace_back(cloud.x[k], cloud.y[k], cloud.z[k]);
        mean += near.back();
      }
    mean /= static_cast<double>(near.size());
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const auto& p : near) scatter += (p - mean) * (p - mean).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
    if (solver.eigenvalues()[1] < 1.2 * solver.eigenvalues()[0]) continue;  // no clear normal
    const Eigen::Vector3d n(surface.normals.x[i], surface.normals.y[i], surface.normals.z[i]);
    EXPECT_NEAR(std::abs(n.dot(solver.eigenvectors().col(0))), 1, 1e-4) << i;
    ++compared;
  }
  EXPECT_GT(compared, 30u);
}

TEST(DownsampleSurface, NormalsOfASphereAreItsRadii) {
  const Surface surface = downsample_surface(emtr_test::sphere(1, 40000, 0.001), 0.03);
  double sum = 0;
  for (std::size_t i = 0; i < surface.points.size(); ++i) {
    const Eigen::Vector3d p(surface.points.x[i], surface.points.y[i], surface.points.z[i]);
    const Eigen::Vector3d n(surface.normals.x[i], surface.normals.y[i], surface.normals.z[i]);
    ASSERT_NEAR(n.norm(), 1, 1e-5);
    sum += std::acos(std::min(1.0, std::abs(n.dot(p.normalized()))));
  }
  EXPECT_LT(sum / static_cast<double>(surface.points.size()) * 180 / M_PI, 2);
}

TEST(DownsampleSurface, PointsAloneOrOnALineHaveNone) {
  Cloud cloud;
  for (int i = 0; i < 200; ++i) push(cloud, 0.001f * static_cast<float>(i), 0.25f, -0.5f);
  push(cloud, -0.9f, 0.3f, 0.3f);
  const Surface surface = downsample_surface(cloud, 0.01);
  ASSERT_GT(surface.points.size(), 10u);
  for (const float x : surface.normals.x) EXPECT_TRUE(std::isnan(x));
}

TEST(DownsampleSurface, OfNoPointsHasNone) {
  const Surface surface = downsample_surface(Cloud(), 0.01);
  EXPECT_EQ(surface.points.size(), 0u);
  EXPECT_EQ(surface.leaf, 0.01);
}

TEST(DownsampleSurface, TakesTheNormalsThatAreGiven) {
  const Cloud cloud = emtr_test::sphere(1, 20000, 0.001);
  const double leaf = 0.05;
  const Surface estimated = downsample_surface(cloud, leaf);
  const Surface surface =
      downsample_surface(cloud, cloud, leaf);  // of a sphere they are the points
  EXPECT_EQ(surface.points.x, estimated.points.x);
  EXPECT_EQ(surface.points.y, estimated.points.y);
  EXPECT_EQ(surface.points.z, estimated.points.z);
  EXPECT_EQ(surface.leaf, leaf);
  ASSERT_EQ(surface.normals.size(), surface.points.size());
  for (std::size_t i = 0; i < surface.points.size(); ++i) {
    const double x = surface.points.x[i], y = surface.points.y[i], z = surface.points.z[i];
    const double dot =
        x * surface.normals.x[i] + y * surface.normals.y[i] + z * surface.normals.z[i];
    EXPECT_NEAR(dot, std::sqrt(x * x + y * y + z * z), 1e-3);
  }
}

}  // namespace
