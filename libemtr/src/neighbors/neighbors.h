#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "geometry/cloud.h"

namespace emtr {

/// Finds the nearest point of one cloud, truncated at a radius: beyond it the M-estimator is flat.
/// The answer is exact within the radius, and every implementation gives the same bits.
class Neighbors {
 public:
  virtual ~Neighbors() = default;

  /// Writes out[i] = min(squared distance of query i to its nearest point, radius^2).
  virtual void squared_distances(const PointsView& queries, float* out) const = 0;

  /// Writes index[i] = the nearest point of query i (the first of several), -1 when none is closer
  /// than the radius, and squared[i] as above.
  virtual void nearest(const PointsView& queries, std::int32_t* index, float* squared) const = 0;
};

/// Returns a squared distance with the order of operations of all implementations.
inline float squared_distance(float dx, float dy, float dz) {
  return (dx * dx + dy * dy) + dz * dz;
}

/// A structure that the memory of a cloud may own.
using SharedNeighbors = std::shared_ptr<const Neighbors>;

std::unique_ptr<Neighbors> make_brute_force(const Cloud& cloud, float radius);

/// Makes a regular grid whose cells each list every point that can be nearest to some place in
/// them. Enlarges `cell` where the grid would take more than 2^22 cells or 2^24 candidates (300
/// MB).
std::unique_ptr<Neighbors> make_candidate_grid(const Cloud& cloud, float radius, float cell,
                                               const Kernels& kernels);

/// Sorts the points by cells as wide as the radius and searches the 27 cells around a query:
/// quicker to make than a candidate grid, slower to query. Takes at most 2^26 cells (17 MB),
/// enlarging them beyond that, and 30 to 130 bytes for each point.
std::unique_ptr<Neighbors> make_voxel_cells(const Cloud& cloud, float radius,
                                            const Kernels& kernels);

/// Returns the side of the cells with which a candidate grid would answer so many queries soonest,
/// its making included; 0 where voxel cells are sooner still.
float plan_cell(const Cloud& cloud, float radius, double queries);

/// Makes the structure planned for `queries` queries; all give the same bits.
std::unique_ptr<Neighbors> make_neighbors(const Cloud& cloud, float radius, double queries,
                                          const Kernels& kernels);

}  // namespace emtr
