#include <gtest/gtest.h>

#include "candidates/upright_points.h"
#include "candidates/yard.h"
#include "ranking/surfaces.h"
#include "refinement/shapes.h"
#include "util/constants.h"

namespace {

using Eigen::Vector3d;

TEST(UprightPoints, AreThoseOfTheWallsInTheFrameOfThePlane) {
  const emtr::Surface yard = emtr_test::yard(-1, 1, 0);
  const auto upright = emtr::upright_points(yard, {Vector3d::UnitZ(), 0, 0.5});
  ASSERT_GT(upright.points.size(), 300u);
  for (const emtr::UprightPoint& p : upright.points) {
    EXPECT_GE(p.height, -1e-9);
    EXPECT_LE(p.height, 0.4);
    EXPECT_GE(p.azimuth, 0);
    EXPECT_LE(p.azimuth, emtr::kPi);
  }
}

TEST(UprightPoints, HeightIsThatAboveThePlaneWhereverItLies) {
  const emtr::Rigid pose = emtr_test::motion({70, 150, -20}, {0.2, -0.1, 0.3});
  const Vector3d up = pose.rotate(Vector3d::UnitZ());
  const auto here = emtr::upright_points(emtr_test::yard(-1, 1, 0), {Vector3d::UnitZ(), 0, 0.5});
  const auto there = emtr::upright_points(emtr_test::moved(emtr_test::yard(-1, 1, 0), pose),
                                          {up, up.dot(pose.t), 0.5});
  ASSERT_EQ(here.points.size(), there.points.size());
  for (std::size_t i = 0; i < here.points.size(); ++i)
    EXPECT_NEAR(here.points[i].height, there.points[i].height, 1e-5);
  const Vector3d origin = there.to_plane * pose.t;  // it lies on the plane
  EXPECT_NEAR(origin.z(), 0, 1e-9);
}

}  // namespace
