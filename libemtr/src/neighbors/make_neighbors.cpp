#include <algorithm>
#include <cmath>

#include "geometry/range.h"
#include "neighbors/neighbors.h"

namespace emtr {
namespace {

constexpr float kCells[] = {1, 1.5f, 2, 3, 4, 6};  // sides of a grid's cells, spacings
constexpr double kCached = 2e6;                    // bytes of a grid that stay near the processor

double extent(const std::vector<float>& axis) {
  const auto [low, high] = range_of(axis);
  return static_cast<double>(high) - static_cast<double>(low);
}

/// Returns about the distance between neighboring points: a scan covers about half of its box's
/// surface.
double estimate_spacing(const Cloud& cloud, double radius) {
  const double sides[3] = {extent(cloud.x), extent(cloud.y), extent(cloud.z)};
  const double area = sides[0] * sides[1] + sides[1] * sides[2] + sides[2] * sides[0];
  return std::sqrt(std::max(area, 9 * radius * radius) / static_cast<double>(cloud.size()));
}

// Nanoseconds, fitted to downsampled scans of 500 to 150 000 points, radii of 1.2 to 5 spacings;
// see tools/bench/neighbors.

double estimate_grid(double n, double radius, double cell, double queries) {
  const double visits = std::pow(2 * radius / cell + 1, 3);  // cells that list a point, at most
  const double misses = std::max(0.0, std::log2(5 * n * visits / kCached));
  return n * (50 + 25 * std::pow(visits, 0.75)) +
         queries * (5 + cell * (3.3 + 1.5 * radius) + 10 * misses);
}

double estimate_voxels(double n, double radius, double queries) {
  return n * (30 + 500 * std::pow(radius, -1.6)) + queries * (5 + radius * (8 + 2 * radius));
}

}  // namespace

float plan_cell(const Cloud& cloud, float radius, double queries) {
  const double n = static_cast<double>(cloud.size()), r = static_cast<double>(radius),
               spacing = estimate_spacing(cloud, r);
  float best = 0;
  double least = estimate_voxels(n, r / spacing, queries);
  for (const float cell : kCells) {
    const double cost = estimate_grid(n, r / spacing, static_cast<double>(cell), queries);
    if (cost < least) best = cell * static_cast<float>(spacing), least = cost;
  }
  return best;
}

std::unique_ptr<Neighbors> make_neighbors(const Cloud& cloud, float radius, double queries,
                                          const Kernels& kernels) {
  const float cell = plan_cell(cloud, radius, queries);
  return cell > 0 ? make_candidate_grid(cloud, radius, cell, kernels)
                  : make_voxel_cells(cloud, radius, kernels);
}

}  // namespace emtr
