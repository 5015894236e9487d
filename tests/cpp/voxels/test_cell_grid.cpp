#include <gtest/gtest.h>

#include <set>

#include "support/clouds.h"
#include "voxels/cell_grid.h"

namespace {

using emtr::CellGrid;
using emtr::Cloud;

float squared(const Cloud& a, std::size_t i, std::size_t j) {
  const float x = a.x[i] - a.x[j], y = a.y[i] - a.y[j], z = a.z[i] - a.z[j];
  return (x * x + y * y) + z * z;
}

void expect_complete(const Cloud& cloud, double side, double radius) {
  const CellGrid grid(cloud, side);
  std::set<std::int32_t> seen(grid.rows.begin(), grid.rows.end());
  ASSERT_EQ(seen.size(), cloud.size());
  const auto limit = static_cast<float>(radius * radius);
  std::vector<CellGrid::Range> ranges;
  std::uint32_t next = 0;
  for (std::size_t cell = 0; cell < grid.occupied(); ++cell) {
    ASSERT_EQ(grid.begin(cell), next);
    ASSERT_LT(next, grid.end(cell));
    next = grid.end(cell);
    grid.around(cell, grid.reach(radius), ranges);
    emtr::NeighborList list;
    list.gather(grid.sorted, ranges);
    ASSERT_EQ(list.size() % emtr::kListStep, 0u);
    for (std::uint32_t i = grid.begin(cell); i < grid.end(cell); ++i) {
      std::size_t expected = 0, found = 0;
      for (std::size_t j = 0; j < cloud.size(); ++j) expected += squared(grid.sorted, i, j) < limit;
      for (const auto& range : ranges)
        for (std::uint32_t j = range.begin; j < range.end; ++j)
          found += squared(grid.sorted, i, j) < limit;
      ASSERT_EQ(found, expected);
    }
  }
  ASSERT_EQ(next, cloud.size());
}

TEST(CellGrid, FindsEveryNeighbor) {
  const Cloud cloud = emtr_test::uniform_cloud(600, 3);
  for (const double radius : {0.05, 0.1, 0.1999, 0.2, 0.5, 5.0})
    expect_complete(cloud, 0.1, radius);
}

TEST(CellGrid, FindsNeighborsExactlyOneCellAway) {  // where rounding could lose them
  Cloud lattice;
  for (int i = 0; i < 9; ++i)
    for (int j = 0; j < 9; ++j)
      for (int k = 0; k < 3; ++k)
        emtr_test::push(lattice, 0.1f * static_cast<float>(i), 0.1f * static_cast<float>(j),
                        0.1f * static_cast<float>(k));
  for (const double radius : {0.1, 0.2, 0.3, 0.30000002}) expect_complete(lattice, 0.1, radius);
}

TEST(CellGrid, StaysSmallWhereACellIsTiny) {
  Cloud cloud = emtr_test::uniform_cloud(300, 4, 1e-3f);
  emtr_test::push(cloud, 1000, 1000, 1000);  // at the given side: 1e21 cells
  expect_complete(cloud, 1e-4, 1e-3);
}

TEST(CellGrid, TakesOnePointAndNone) {
  expect_complete(emtr_test::uniform_cloud(1, 1), 0.1, 0.2);
  EXPECT_EQ(CellGrid(Cloud(), 0.1).occupied(), 0u);
}

}  // namespace
