#include <gtest/gtest.h>

#include <cmath>

#include "candidates/dominant_planes.h"
#include "candidates/yard.h"
#include "ranking/surfaces.h"
#include "refinement/shapes.h"

namespace {

using Eigen::Vector3d;
using emtr::DominantPlane;

TEST(DominantPlanes, GroundComesFirstAndIsOrientedTowardsWhatStandsOnIt) {
  const emtr::Rigid pose = emtr_test::motion({70, 150, -20}, {0.2, -0.1, 0.3});
  const auto planes = emtr::dominant_planes(emtr_test::moved(emtr_test::yard(-1, 1, 0), pose), 2);
  ASSERT_FALSE(planes.empty());
  const Vector3d up = pose.rotate(Vector3d::UnitZ());
  EXPECT_NEAR(planes[0].normal.dot(up), 1, 1e-4);
  EXPECT_NEAR(planes[0].offset, up.dot(pose.t), 0.01);
  EXPECT_GT(planes[0].share, 0.4);
}

TEST(DominantPlanes, AWallComesSecond) {
  emtr::Surface walled = emtr_test::yard(-1, 1, 0);
  for (double x = -0.9; x < 0.9; x += 0.03)
    for (double z = 0; z < 0.9; z += 0.03) emtr_test::push(walled, {x, 0.7, z}, {0, -1, 0});
  const auto planes = emtr::dominant_planes(walled, 3);
  ASSERT_EQ(planes.size(), 2u);
  EXPECT_NEAR(planes[1].normal.dot(-Vector3d::UnitY()), 1, 1e-3);
  EXPECT_NEAR(planes[1].offset, -0.7, 0.03);
  for (const DominantPlane& plane : planes) {
    EXPECT_NEAR(plane.normal.norm(), 1, 1e-9);
    EXPECT_GE(plane.share, emtr::kLeastPlane);
  }
}

TEST(DominantPlanes, TerracesAreTwo) {
  emtr::Surface terraces;
  for (double x = 0; x < 1; x += 0.03)
    for (double y = 0; y < 1; y += 0.03)
      emtr_test::push(terraces, {x, y, x < 0.6 ? 0 : 0.1}, {0, 0, 1});
  const auto planes = emtr::dominant_planes(terraces, 3);
  ASSERT_EQ(planes.size(), 2u);
  EXPECT_NEAR(std::abs(planes[0].offset), 0, 1e-3);
  EXPECT_NEAR(std::abs(planes[1].offset), 0.1, 1e-3);
}

TEST(DominantPlanes, ABallHasNone) {
  emtr_test::Draw draw(3);
  emtr::Surface ball;
  ball.leaf = 0.05;
  for (int i = 0; i < 2000; ++i) {
    const Vector3d n = draw.direction();
    emtr_test::push(ball, {n.x(), n.y(), n.z()}, {n.x(), n.y(), n.z()});
  }
  EXPECT_TRUE(emtr::dominant_planes(ball, 2).empty());
}

TEST(DominantPlanes, PointsWithoutNormalsHaveNone) {
  emtr::Surface bare = emtr_test::yard(-1, 1, 0);
  const float none[3] = {NAN, NAN, NAN};
  for (std::size_t i = 0; i < bare.normals.size(); ++i) bare.normals.set(i, none);
  EXPECT_TRUE(emtr::dominant_planes(bare, 2).empty());
}

}  // namespace
