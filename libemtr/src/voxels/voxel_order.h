#pragma once

#include <cstdint>
#include <vector>

#include "geometry/cloud.h"

namespace emtr {

/// The number of a point's voxel and the point's row.
struct VoxelRow {
  std::uint64_t voxel;
  std::uint32_t row;
};

/// Sorts by voxel and keeps the order of the rows within each. No voxel's number may be larger than
/// `maximum`.
void sort_by_voxel(std::vector<VoxelRow>& items, std::uint64_t maximum);

/// Returns all points sorted by voxel, in the order of voxel_grid(): by z, then y, then x, and
/// within a voxel by row. Takes normalized clouds only and a `leaf` of at least 2e-3.
std::vector<VoxelRow> rows_by_voxel(const Cloud& cloud, float leaf);

/// Returns, in ascending order, one row for each voxel that holds points: the point nearest to the
/// voxel's center, the first of several. The order of the points does not change which points they
/// are.
std::vector<std::uint32_t> one_row_per_voxel(const Cloud& cloud, float leaf);

/// Returns the mean direction, of unit length, of the normals in the voxel of each point of
/// voxel_grid(cloud, leaf), in its order. It is NaN, as is the normal of a point without one, where
/// no point of the voxel has a normal or the normals cancel out.
Cloud mean_normals(const Cloud& cloud, const Cloud& normals, float leaf);

/// Returns the mean color of the points in each such voxel that have one, in the same order; NaN
/// where none has.
Cloud mean_colors(const Cloud& cloud, const Cloud& colors, float leaf);

}  // namespace emtr
