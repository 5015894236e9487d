#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "geometry/cloud.h"

namespace emtr {

/// Nearest point of one cloud, truncated at a radius: beyond it the M-estimator is flat, so no
/// more need be known. Exact within; every implementation gives the same bits.
class Neighbors {
 public:
  virtual ~Neighbors() = default;

  /// out[i] = min(squared distance of query i to its nearest point, radius^2).
  virtual void squared_distances(const PointsView& queries, float* out) const = 0;

  /// index[i] = the nearest point of query i (the first of several), -1 when none is closer than
  /// the radius; squared[i] as above.
  virtual void nearest(const PointsView& queries, std::int32_t* index, float* squared) const = 0;
};

/// The one formula of a squared distance, in this order of operations, for all of them.
inline float squared_distance(float dx, float dy, float dz) {
  return (dx * dx + dy * dy) + dz * dz;
}

std::unique_ptr<Neighbors> make_brute_force(const Cloud& cloud, float radius);

/// Each cell of a regular grid lists every point that can be nearest to some place in it. `cell`
/// is a wish: it grows where the grid would take more than 2^22 cells or 2^24 candidates (300 MB).
std::unique_ptr<Neighbors> make_candidate_grid(const Cloud& cloud, float radius, float cell,
                                               const Kernels& kernels);

/// Points sorted by voxels as wide as the radius, the 27 around a query looked through: quicker
/// made than a candidate grid, slower to ask. At most 2^26 voxels (17 MB), then they grow; 30 to
/// 130 bytes a point.
std::unique_ptr<Neighbors> make_voxel_cells(const Cloud& cloud, float radius,
                                            const Kernels& kernels);

/// Nanoseconds that each would take to be made and asked `queries` times, about.
struct NeighborCosts {
  double candidate_grid, voxel_cells;
};
NeighborCosts estimate_costs(const Cloud& cloud, float radius, float leaf, double queries);

/// The cheaper of the two; both give the same bits. `leaf` is the side of the grid's cells.
std::unique_ptr<Neighbors> make_neighbors(const Cloud& cloud, float radius, float leaf,
                                          double queries, const Kernels& kernels);

}  // namespace emtr
