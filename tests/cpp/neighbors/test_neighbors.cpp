#include <gtest/gtest.h>

#include <functional>
#include <ostream>

#include "features/kdtree_neighbors.h"
#include "neighbors/neighbors.h"
#include "support/clouds.h"

namespace {

using emtr::Cloud;
using emtr_test::push;
using emtr_test::uniform_cloud;

Cloud clustered(unsigned seed) {
  Cloud cloud = uniform_cloud(20, seed);
  std::mt19937 random(seed + 1);
  for (int i = 0; i < 600; ++i) {
    const std::size_t k = random() % 20;
    const auto near = [&](float v) { return v + static_cast<float>(random() % 1000) * 2e-5f; };
    push(cloud, near(cloud.x[k]), near(cloud.y[k]), near(cloud.z[k]));
  }
  return cloud;
}

Cloud collinear(unsigned) {
  Cloud cloud;
  for (int i = 0; i < 300; ++i) push(cloud, static_cast<float>(i) / 150 - 1, 0.25f, -0.5f);
  return cloud;
}

Cloud duplicates(unsigned seed) {
  Cloud cloud = uniform_cloud(100, seed);
  const Cloud once = cloud;
  for (std::size_t i = 0; i < once.size(); ++i) push(cloud, once.x[i], once.y[i], once.z[i]);
  return cloud;
}

Cloud lattice(unsigned) {  // points on cell boundaries, many ties
  Cloud cloud;
  for (int i = -4; i <= 4; ++i)
    for (int j = -4; j <= 4; ++j)
      for (int k = -4; k <= 4; ++k)
        push(cloud, 0.1f * static_cast<float>(i), 0.1f * static_cast<float>(j),
             0.1f * static_cast<float>(k));
  return cloud;
}

struct Shape {
  const char* name;
  std::function<Cloud(unsigned)> make;
};

void PrintTo(const Shape& shape, std::ostream* out) { *out << shape.name; }

class Neighbors : public testing::TestWithParam<Shape> {};

/// Uniform queries, the points themselves, and places just beside them and at the truncation.
Cloud queries_for(const Cloud& cloud, float radius, unsigned seed) {
  Cloud q = uniform_cloud(500, seed, 1.5f);
  for (std::size_t i = 0; i < cloud.size(); i += 3) {
    push(q, cloud.x[i], cloud.y[i], cloud.z[i]);
    push(q, std::nextafter(cloud.x[i], 2.0f), cloud.y[i], cloud.z[i]);
    push(q, cloud.x[i] + radius, cloud.y[i], cloud.z[i]);
    push(q, cloud.x[i] + 0.99f * radius, cloud.y[i], cloud.z[i]);
  }
  return q;
}

TEST_P(Neighbors, EveryStructureGivesTheBitsOfBruteForce) {
  for (unsigned seed = 0; seed < 3; ++seed)
    for (const float radius : {0.03f, 0.15f, 0.7f}) {
      const Cloud cloud = GetParam().make(seed);
      const Cloud q = queries_for(cloud, radius, seed + 100);
      const std::size_t n = q.size();
      struct Answer {
        std::vector<float> batch, squared;
        std::vector<std::int32_t> index;
      };
      const auto ask = [&](const emtr::Neighbors& structure) {
        Answer a{std::vector<float>(n), std::vector<float>(n), std::vector<std::int32_t>(n)};
        structure.squared_distances(q.view(), a.batch.data());
        structure.nearest(q.view(), a.index.data(), a.squared.data());
        return a;
      };
      const Answer truth = ask(*emtr::make_brute_force(cloud, radius));
      for (const emtr::Kernels* kernels : emtr_test::kernels_here()) {
        const Answer voxels = ask(*emtr::make_voxel_cells(cloud, radius, *kernels));
        EXPECT_EQ(voxels.batch, truth.batch) << kernels->name;
        EXPECT_EQ(voxels.squared, truth.squared);
        EXPECT_EQ(voxels.index, truth.index);
        for (const float cell : {0.2f * radius, 0.9f * radius}) {
          const Answer grid = ask(*emtr::make_candidate_grid(cloud, radius, cell, *kernels));
          EXPECT_EQ(grid.batch, truth.batch) << kernels->name;
          EXPECT_EQ(grid.squared, truth.squared);
          EXPECT_EQ(grid.index, truth.index);
        }
      }
      const Answer tree = ask(*emtr::make_kdtree(cloud, radius));
      EXPECT_EQ(tree.batch, truth.batch);
      EXPECT_EQ(tree.squared, truth.squared);
      EXPECT_EQ(tree.index, truth.index);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, Neighbors,
    testing::Values(Shape{"uniform", [](unsigned s) { return uniform_cloud(700, s); }},
                    Shape{"plane", [](unsigned s) { return uniform_cloud(700, s, 1, 0); }},
                    Shape{"clustered", clustered}, Shape{"collinear", collinear},
                    Shape{"duplicates", duplicates}, Shape{"lattice", lattice},
                    Shape{"single", [](unsigned s) { return uniform_cloud(1, s); }}),
    [](const auto& shape) { return shape.param.name; });

TEST(CandidateGrid, IsCappedWhenCellsWouldBeTooMany) {
  const Cloud cloud = uniform_cloud(50, 7);
  const Cloud q = uniform_cloud(200, 8);
  std::vector<float> grid(q.size()), brute(q.size());
  const auto ask = [&](const emtr::Neighbors& s, std::vector<float>& out) {
    s.squared_distances(q.view(), out.data());
  };
  ask(*emtr::make_candidate_grid(cloud, 0.2f, 1e-4f, emtr::select_kernels()),
      grid);  // 10^13 cells as asked
  ask(*emtr::make_brute_force(cloud, 0.2f), brute);
  EXPECT_EQ(grid, brute);
}

}  // namespace
