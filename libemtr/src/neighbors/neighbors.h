#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "../cloud.h"

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
/// is a wish: it grows where the grid would take more than a few million cells.
std::unique_ptr<Neighbors> make_candidate_grid(const Cloud& cloud, float radius, float cell,
                                               const Kernels& kernels);

/// Points sorted by voxels as wide as the radius, the 27 around a query looked through: much
/// quicker made than a candidate grid, slower to ask.
std::unique_ptr<Neighbors> make_voxel_cells(const Cloud& cloud, float radius,
                                            const Kernels& kernels);

}  // namespace emtr
