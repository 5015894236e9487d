#include <gtest/gtest.h>

#include <functional>
#include <ostream>

#include "neighbors/kdtree_neighbors.h"
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

TEST(Structures, FarFromTheOriginAndAlongThousandsOfCells) {
  Cloud cloud = uniform_cloud(1500, 11, 1, 1), q = uniform_cloud(1500, 12, 1, 1);
  for (Cloud* c : {&cloud, &q})
    for (std::size_t i = 0; i < c->size(); ++i) {
      c->x[i] = 30 * c->x[i] + 100;  // rounding is a hundredth of the radius and more
      c->y[i] = 0.001f * c->y[i] - 50;
      c->z[i] = 0.001f * c->z[i];
    }
  for (const float radius : {0.001f, 0.02f}) {
    std::vector<float> found(q.size()), brute(q.size());
    std::vector<std::int32_t> index(q.size()), brute_index(q.size());
    emtr::make_brute_force(cloud, radius)->nearest(q.view(), brute_index.data(), brute.data());
    for (const auto& structure :
         {emtr::make_candidate_grid(cloud, radius, 0.5f * radius, emtr::select_kernels()),
          emtr::make_voxel_cells(cloud, radius, emtr::select_kernels())}) {
      structure->nearest(q.view(), index.data(), found.data());
      EXPECT_EQ(found, brute);
      EXPECT_EQ(index, brute_index);
    }
  }
}

TEST(Structures, ManyCandidatesMakeTheCellsGrow) {
  // All but one place, seen from afar: each of the 250 000 cells would list each point.
  const Cloud cloud = uniform_cloud(300, 13, 0.0002f);
  const Cloud q = uniform_cloud(500, 14, 0.3f);
  std::vector<float> grid(q.size()), voxels(q.size()), brute(q.size());
  const emtr::Kernels& kernels = emtr::select_kernels();
  emtr::make_candidate_grid(cloud, 0.3f, 0.01f, kernels)->squared_distances(q.view(), grid.data());
  emtr::make_voxel_cells(cloud, 0.3f, kernels)->squared_distances(q.view(), voxels.data());
  emtr::make_brute_force(cloud, 0.3f)->squared_distances(q.view(), brute.data());
  EXPECT_EQ(grid, brute);
  EXPECT_EQ(voxels, brute);
}

TEST(MakeNeighbors, BuildsWhatTheQueriesPayFor) {
  const Cloud small = uniform_cloud(2000, 1, 1, 0), large = uniform_cloud(100000, 1, 1, 0);
  EXPECT_EQ(emtr::plan_cell(small, 0.15f, 2e3), 0);
  EXPECT_EQ(emtr::plan_cell(large, 0.03f, 1e5), 0);
  EXPECT_GT(emtr::plan_cell(small, 0.15f, 4e6), 0);
  EXPECT_GT(emtr::plan_cell(small, 0.5f, 4e6), 0);  // a voxel would have half of the points
  // More queries pay for finer cells, down to the spacing of the points.
  EXPECT_GT(emtr::plan_cell(small, 0.15f, 1e5), emtr::plan_cell(small, 0.15f, 4e6));
  EXPECT_EQ(emtr::plan_cell(small, 0.15f, 1e9), emtr::plan_cell(small, 0.15f, 1e12));
}

TEST(MakeNeighbors, GivesTheBitsOfBruteForceWhateverItsPlan) {
  const Cloud cloud = uniform_cloud(800, 5), q = uniform_cloud(900, 6, 1.2f);
  std::vector<float> found(q.size()), brute(q.size());
  emtr::make_brute_force(cloud, 0.2f)->squared_distances(q.view(), brute.data());
  for (const double queries : {1e2, 1e5, 1e9}) {
    emtr::make_neighbors(cloud, 0.2f, queries, emtr::select_kernels())
        ->squared_distances(q.view(), found.data());
    EXPECT_EQ(found, brute);
  }
}

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
