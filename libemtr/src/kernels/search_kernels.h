#pragma once

#include <cstddef>
#include <cstdint>

#include "kernels/kernels.h"

// Declares the inner loops of single steps of the search: candidate grids that are made, seeds,
// a sensor's place, votes for translations, sums over the matched pairs of a pose. The rules of
// kernels/kernels.h hold for them too.

namespace emtr {

/// A grid of cells that is being made, and how far its points reach.
struct ReachView {
  CellsView cells;  ///< without groups
  float radius;     ///< of the points' reach
  float cell;       ///< side of a cell
  float margin;     ///< in cells: how far rounding can move a point at most
};

/// Returns the number of floats of working memory that the kernels of a ReachView need.
inline std::size_t reach_room(const ReachView& grid) {
  const float span = grid.radius * grid.cells.inverse_cell + grid.margin;
  const auto most = static_cast<std::size_t>(2 * span) + 3;
  return 6 * (most + 2 * kLanes);
}

/// Where the candidates of each cell are written. The arrays of cells have room for kLanes more.
struct CandidateLists {
  const std::uint32_t* place;  ///< of each cell that has candidates, among those that have
  const std::uint32_t* more;   ///< as in a GridView
  std::uint32_t* filled;       ///< candidates written so far, by place
  float* blocks;               ///< as in a GridView
  std::int32_t* index;         ///< row in the cloud of each candidate
};

/// Sampled points of a surface, in all arrays a multiple of kLanes; see ranking/sampling_viewpoint.
struct SamplingView {
  const float *x, *y, *z, *nx, *ny, *nz;
  const float* log_count;  ///< how densely the surface was sampled there
  const float* present;    ///< 1, and 0 for padding
  std::size_t size;
};

/// A source and a target point that vote together.
struct VotePair {
  std::uint16_t source, target;
};

/// Cells of translations in a plane, within a border of one cell.
struct VoteCells {
  double reach, cell;  ///< least translation, negative, and side of a cell
  std::int32_t cells;  ///< along each axis
  std::int32_t row;    ///< cells from one row to the next
};

/// Matched pairs, in all arrays a multiple of kLanes; padding has normals of NaN.
struct PairsView {
  const float *source[6], *target[6];  ///< x, y, z and the normal's
  std::size_t size;
};

/// The parameters of refinement/plane_to_plane.
struct PlaneToPlaneView {
  double R[9], t[3];  ///< of the pose; row-major
  double inverse_squared_scale, softness, gate;
};

constexpr std::size_t kPairSums = 42;  ///< the numbers of refinement/normal_equations, in order

/// Bins of directions, see ranking/direction_bins; columns and rows may be one beyond the last.
struct BinsOut {
  std::int32_t *face, *column, *row;
};

/// One implementation of these loops. All give the same bits.
struct SearchKernels {
  /// Lowers bound[c] to the squared distance from a point to the farthest place of cell c, for each
  /// point and each cell that it reaches. The entries begin at grid.cells.limit at most.
  void (*reach_bounds)(const ReachView& grid, const PointsView& points, float* room, float* bound);

  /// Counts the candidates of each cell: the points no farther from its nearest place than its
  /// bound, which is no more than 1.0005 times grid.cells.limit.
  void (*count_candidates)(const ReachView& grid, const PointsView& points, float* room,
                           const float* bound, std::uint32_t* count);

  /// Writes the same candidates. The first point is row `first` of the cloud.
  void (*list_candidates)(const ReachView& grid, const PointsView& points, std::size_t first,
                          float* room, const float* bound, const CandidateLists& lists);

  /// Writes the bits of the pairs with |R p + t - q|^2 < squared_threshold, computed in double, and
  /// returns how many they are; `matrix` is [R t], row-major. The arrays have room for a multiple
  /// of 64 points; bits past the last are 0.
  std::size_t (*pose_inliers)(const PointsView& p, const PointsView& q, const double* matrix,
                              double squared_threshold, std::uint64_t* bits);

  /// Writes three sums over the points, of what a scanner at this place would have sampled: of the
  /// logarithm, of its square, and of its product with log_count.
  void (*sampling_sums)(const SamplingView& points, const float* at, double* out);

  /// Adds rho(squared[i]) to lane i % kLanes of the sums; n is a multiple of kLanes but in the last
  /// call. total_of_lanes() of them is Kernels::rho_sum() of all.
  void (*add_rho)(const float* squared, std::size_t n, float inverse_squared_scale, double* sums);

  /// Writes the sums over all pairs.
  void (*plane_to_plane)(const PairsView& pairs, const PlaneToPlaneView& at, double* sums);

  /// Writes the bin of each direction, of any length. All arrays have room for a multiple of 16.
  void (*direction_bins)(const PointsView& directions, float half_side, const BinsOut& out);

  /// Adds a vote for each pair's translation target - source to its cell; one of a translation
  /// beyond the cells goes to votes[row * row].
  void (*vote)(const VotePair* pairs, std::size_t n, const double* const source[2],
               const double* const target[2], const VoteCells& cells, std::int32_t* votes);
};

/// Returns the sum of kLanes lanes, in the one order of all kernels.
inline double total_of_lanes(const double* lanes) {
  return ((lanes[0] + lanes[4]) + (lanes[2] + lanes[6])) +
         ((lanes[1] + lanes[5]) + (lanes[3] + lanes[7]));
}

/// Returns the loops of the same instruction set.
const SearchKernels& search_kernels(const Kernels& kernels);

}  // namespace emtr
