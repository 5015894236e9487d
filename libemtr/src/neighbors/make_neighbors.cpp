#include <algorithm>
#include <cmath>

#include "neighbors/neighbors.h"

namespace emtr {
namespace {

// Nanoseconds, measured on downsampled scans of 600 to 100 000 points; see tools/bench/neighbors.
constexpr double kGridReach = 8, kGridQuery = 5;
constexpr double kVoxelPoint = 250, kVoxelQuery = 5, kVoxelStep = 0.6;

double extent(const std::vector<float>& axis) {
  const auto [low, high] = std::minmax_element(axis.begin(), axis.end());
  return static_cast<double>(*high) - static_cast<double>(*low);
}

}  // namespace

NeighborCosts estimate_costs(const Cloud& cloud, float radius, float leaf, double queries) {
  const double n = static_cast<double>(cloud.size()), r = static_cast<double>(radius);
  const double sides[3] = {extent(cloud.x), extent(cloud.y), extent(cloud.z)};
  const double reach = std::pow(2 * r / static_cast<double>(leaf) + 1, 3);  // cells of a point
  // A scan covers about half of its box's surface. A query reads the points of an area of three by
  // three cells, eight in a step, and takes a few more steps because rows of cells end anywhere.
  const double area = sides[0] * sides[1] + sides[1] * sides[2] + sides[2] * sides[0];
  const double near = n * std::min(1.0, 9 * r * r / std::max(area, 9 * r * r));
  return {n * kGridReach * reach + queries * kGridQuery,
          n * kVoxelPoint + queries * (kVoxelQuery + kVoxelStep * (2.5 + near / 8))};
}

std::unique_ptr<Neighbors> make_neighbors(const Cloud& cloud, float radius, float leaf,
                                          double queries, const Kernels& kernels) {
  const NeighborCosts costs = estimate_costs(cloud, radius, leaf, queries);
  if (costs.voxel_cells < costs.candidate_grid) return make_voxel_cells(cloud, radius, kernels);
  return make_candidate_grid(cloud, radius, leaf, kernels);
}

}  // namespace emtr
