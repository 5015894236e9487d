#pragma once

#include <cstddef>
#include <cstdint>

// Declares the inner loops, which are compiled once for each instruction set. These files know
// nothing but arrays: code shared with the rest (Eigen, PCL, the standard containers) would be
// compiled with those instructions too, and the linker might pick that copy for a machine without
// them.

namespace emtr {

constexpr std::size_t kLanes = 8;  ///< floats side by side, in every kernel

/// 32 cells: a bit for each that has points near, and the number of such cells before them.
struct CellGroup {
  std::uint32_t occupied, before;
};

/// A regular grid of cells; a query beyond belongs to the cell at the edge.
struct CellsView {
  float origin[3], inverse_cell;
  std::int32_t size[3];  ///< cells along each axis, the first one fastest
  float limit;           ///< squared radius, the answer where no point is nearer
  const CellGroup* groups;
};

/// A candidate grid (see neighbors/candidate_grid) as bare arrays. Candidates lie in blocks of
/// kLanes x, kLanes y, kLanes z. The k-th occupied cell lists block k and then the blocks more[k]
/// to more[k + 1].
struct GridView {
  CellsView cells;
  const std::uint32_t* more;
  const float* blocks;
};

/// Points sorted by cells (see neighbors/voxel_cells) as bare arrays. The points near the k-th
/// occupied cell are among those at kLanes places from each of starts[begin[k]] to starts[begin[k +
/// 1]] on.
struct VoxelView {
  CellsView cells;
  const std::uint32_t *begin, *starts;
  const float *x, *y, *z;
  const std::int32_t* index;  ///< row in the cloud of each place
};

/// Points as a structure of arrays.
struct PointsView {
  const float *x, *y, *z;
  std::size_t size;
};

/// Points with their normals as a structure of arrays.
struct SurfaceView {
  PointsView points;
  const float *nx, *ny, *nz;
};

/// A point with its normal, beside each other in half a cache line.
struct alignas(32) SurfacePoint {
  float p[3], n[3];
};

/// Lists of neighbors for the descriptors are padded to a multiple of this.
constexpr std::size_t kListStep = 16;
/// Padding lies at this coordinate: it is nobody's neighbor, and its square is finite.
constexpr float kFarAway = 1e18f;

constexpr std::size_t kMoments = 10;            ///< count, x, y, z, xx, xy, xz, yy, yz, zz
constexpr std::size_t kBins = 11;               ///< in each of a descriptor's three histograms
constexpr std::size_t kDescriptor = 3 * kBins;  ///< numbers of FPFH
constexpr std::size_t kDescriptorRow = 36;    ///< floats from one histogram to the next, zeros last
constexpr std::size_t kDescriptorBlock = 32;  ///< descriptors side by side in a DescriptorBlocks

/// Descriptors in blocks of kDescriptorBlock: [block][number of the descriptor][descriptor of the
/// block], NaN after the last.
struct DescriptorBlocks {
  const float* values;
  std::size_t blocks;
  std::size_t dimension;  ///< numbers of each; kDescriptor is the fastest for its size
};

constexpr std::size_t kPrincipal = 16;  ///< coordinates that bound the distance of descriptors

/// kDescriptorBlock descriptors that are near each other, NaN after the last; see
/// correspondences/principal_blocks.
struct PrincipalBlock {
  const float* values;        ///< [number of the descriptor][descriptor of the block]
  const float* principal;     ///< [coordinate][descriptor of the block]
  const float *low, *high;    ///< the box of the coordinates
  const std::int32_t* index;  ///< by which the other side knows each; -1 after the last
  std::size_t first;          ///< place of the first descriptor in the lists
};

/// How much less than it is a distance may look by its coordinates: `factor` times the squared
/// distance and `slack` are an upper bound of the squared distance of the coordinates.
struct DistanceBound {
  float factor, slack;
};

/// The k nearest of each of some items, nearest first: the j-th of item i lies at [j * stride + i].
/// Infinity and -1 where there are fewer.
struct NearestLists {
  float* squared;
  std::int32_t* index;
  std::size_t stride, k;
};

/// The consensus of TIMs under a rotation.
struct Consensus {
  double inliers, residuals;  ///< their number and the sum of their |q - R p|
};

/// Returns the number of floats of working memory that `consensus` needs.
constexpr std::size_t consensus_room(std::size_t correspondences) {
  return 3 * (correspondences + 16) + 6 * (correspondences / 16 + 1);
}

/// One implementation of all inner loops. All give the same bits: the operations on each number and
/// the order of each sum are fixed, and only the number of lanes differs.
struct Kernels {
  const char* name;

  /// Writes out[i] = R p[i] + t; R row-major.
  void (*transform)(const PointsView& points, const float* R, const float* t, float* x, float* y,
                    float* z);

  /// Writes out[i] = min(squared distance of query i to its nearest point, limit).
  void (*squared_distances)(const GridView& grid, const PointsView& queries, float* out);

  /// Writes the same, and candidate[i] = the place of the nearest point in the grid's lists, the
  /// first of several; -1 when none is closer than the radius.
  void (*nearest)(const GridView& grid, const PointsView& queries, std::int32_t* candidate,
                  float* squared);

  /// Write the same for points sorted by cells, with index[i] = the row of the nearest point, the
  /// smallest of several.
  void (*voxel_squared_distances)(const VoxelView& voxels, const PointsView& queries, float* out);
  void (*voxel_nearest)(const VoxelView& voxels, const PointsView& queries, std::int32_t* index,
                        float* squared);

  /// Returns the sum of rho(squared[i]) over fixed lanes: 1 - (1 - squared / c^2)^3.
  double (*rho_sum)(const float* squared, std::size_t n, float inverse_squared_scale);

  /// Counts and sums the inliers among the TIMs of all pairs of correspondences p, q: those with
  /// |q_jk - R p_jk|^2 < squared_threshold; R row-major. Fastest when neighbors lie side by side.
  Consensus (*consensus)(const PointsView& p, const PointsView& q, const float* R,
                         float squared_threshold, float* room);

  /// Writes the bits of one row: bit j is set when | |p_j - p_i| - |q_j - q_i| | < threshold. The
  /// arrays have room for a multiple of 64 points; bits past the last point mean nothing.
  void (*consistent)(const PointsView& p, const PointsView& q, std::size_t i, float threshold,
                     std::uint64_t* bits);

  /// Counts the bits that are set in both.
  std::size_t (*count_common)(const std::uint64_t* a, const std::uint64_t* b, std::size_t words);

  /// Writes sums over the points nearer than the radius, relative to the query; sum m goes to
  /// out[m * stride].
  void (*moments)(const PointsView& list, const float* query, float squared_radius, float* out,
                  std::size_t stride);

  /// Writes the normal of the plane through each of points.size neighborhoods, oriented towards the
  /// viewpoint: the direction of the smallest variance. NaN for fewer than three points or where no
  /// variance is clearly the smallest.
  void (*plane_normals)(const float* moments, std::size_t stride, const PointsView& points,
                        const float* viewpoint, float* nx, float* ny, float* nz);

  /// Writes the simplified point feature histogram of the query among its neighbors, kDescriptorRow
  /// floats.
  void (*pair_histograms)(const SurfaceView& list, const SurfacePoint& query, float squared_radius,
                          float* out);

  /// Writes the sum of the neighbors' histograms over squared distance, each of the three scaled to
  /// 100, kDescriptor floats. The histogram of list[i] is row rows[i].
  void (*weighted_histograms)(const PointsView& list, const std::uint32_t* rows, const float* query,
                              float squared_radius, const float* histograms, float* out);

  /// Returns the squared distance to the nearest of the list.
  float (*minimum_squared_distance)(const PointsView& list, const float* query);

  /// Compares `count` descriptors of the blocks' dimension, packed, with all of the blocks and
  /// enters each pair in both lists, that of the rows and that of the columns. Row r is known to
  /// the columns as first_row + r; call with growing first_row, so that of equal distances the
  /// smaller index stays.
  void (*nearest_descriptors)(const float* rows, std::size_t count, std::int32_t first_row,
                              const DescriptorBlocks& columns, const NearestLists& of_rows,
                              const NearestLists& of_columns);

  /// Enters the pairs of one block of rows and one of columns that can be among the k nearest in
  /// both lists, of equal distances those of the smaller index. The distances are the same bits as
  /// above. No list need have what is beyond `known`, which has an entry for each of the columns.
  void (*nearest_in_blocks)(const PrincipalBlock& rows, const PrincipalBlock& columns,
                            std::size_t dimension, const DistanceBound& bound, const float* known,
                            const NearestLists& of_rows, const NearestLists& of_columns);
};

/// Returns the fastest kernels that this machine can run, or those that the variable EMTR_KERNEL
/// names: generic, avx2 or avx512. Throws Error when there are none of that name or they cannot run
/// here.
const Kernels& select_kernels();

/// Returns kernels by index, whether or not this machine can run them; null past the last.
const Kernels* kernels_at(std::size_t index);
bool can_run(const Kernels& kernels);

}  // namespace emtr
