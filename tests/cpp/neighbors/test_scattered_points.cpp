#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "neighbors/scattered_points.h"
#include "refinement/shapes.h"

namespace {

using Eigen::Vector3d;

void append(emtr::Cloud& cloud, const Vector3d& p) {
  const Eigen::Vector3f f = p.cast<float>();
  cloud.append(f.x(), f.y(), f.z());
}

emtr::Cloud sphere(std::size_t points, double noise = 0) {
  emtr_test::Draw draw(7);
  emtr::Cloud out;
  for (std::size_t i = 0; i < points; ++i)
    append(out, (0.8 + noise * draw.uniform(-1, 1)) * draw.direction());
  return out;
}

TEST(ScatteredPoints, OutliersAllOverSpaceAreFoundAndTheSurfaceStays) {
  emtr::Cloud cloud = sphere(400, 0.01);
  emtr_test::Draw draw(8);
  std::size_t far = 0;
  for (int i = 0; i < 300; ++i) {
    const Vector3d p(draw.uniform(-1, 1), draw.uniform(-1, 1), draw.uniform(-1, 1));
    far += std::abs(p.norm() - 0.8) > 0.2;
    append(cloud, p);
  }
  const auto rows = emtr::rows_on_surface(cloud);
  std::size_t of_sphere = 0;
  for (const std::size_t row : rows) of_sphere += row < 400;
  EXPECT_GT(of_sphere, 380u);
  EXPECT_LT(rows.size() - of_sphere, 300 - far / 2);
}

TEST(ScatteredPoints, ANoisySurfaceHasNone) {
  for (const double noise : {0.0, 0.02, 0.06})
    EXPECT_EQ(emtr::rows_on_surface(sphere(600, noise)).size(), 600u) << noise;
}

TEST(ScatteredPoints, SparsePartsOfASurfaceStay) {
  emtr_test::Draw draw(9);
  emtr::Cloud ground;  // as a scanner sees it that stands in the middle
  for (int i = 0; i < 2000; ++i) {
    const double radius = std::pow(draw.uniform(0.05, 1), 3), angle = draw.uniform(0, 6.28);
    append(ground,
           {radius * std::cos(angle), radius * std::sin(angle), 0.001 * draw.uniform(-1, 1)});
  }
  EXPECT_EQ(emtr::rows_on_surface(ground).size(), ground.size());
}

TEST(ScatteredPoints, AllAreKeptOfPointsThatAreNoSurfaceAtAll) {
  emtr_test::Draw draw(10);
  emtr::Cloud space;
  for (int i = 0; i < 500; ++i)
    append(space, {draw.uniform(-1, 1), draw.uniform(-1, 1), draw.uniform(-1, 1)});
  EXPECT_EQ(emtr::rows_on_surface(space).size(), space.size());
  for (int i = 0; i < 200; ++i) append(space, 0.1 * draw.uniform(0, 1) * draw.direction());
  EXPECT_EQ(emtr::rows_on_surface(space).size(), space.size());  // with a cluster
}

TEST(ScatteredPoints, FewPointsAndDuplicatesAreKept) {
  EXPECT_EQ(emtr::rows_on_surface(sphere(8)).size(), 8u);
  emtr::Cloud twice = sphere(40);
  for (int k = 0; k < 12; ++k) twice.append(sphere(20));
  EXPECT_EQ(emtr::rows_on_surface(twice).size(), twice.size());
}

}  // namespace
