#pragma once

#include <cstdint>
#include <vector>

#include "geometry/cloud.h"

namespace emtr {

/// A point's cube of side `leaf`, binned as pcl::VoxelGrid bins, and its row.
struct VoxelRow {
  std::uint64_t cube;
  std::uint32_t row;
};

/// By cube, rows of one cube in their order. Larger than `most` is no cube's number.
void sort_by_voxel(std::vector<VoxelRow>& items, std::uint64_t most);

/// All points by their cube, in the order of voxel_grid(): by z, then y, then x; those of one cube
/// by row. On normalized clouds only, `leaf` of 2e-3 and more.
std::vector<VoxelRow> rows_by_voxel(const Cloud& cloud, float leaf);

/// One point of each cube that holds points, the nearest to its centre (the first of several):
/// their rows, ascending. Which ones they are does not depend on the order of the points.
std::vector<std::uint32_t> one_row_per_voxel(const Cloud& cloud, float leaf);

/// For each point of voxel_grid(cloud, leaf), in its order, the mean direction of the normals in
/// its cube, of unit length. NaN, as the normal of a point that has none, where no point of the
/// cube has one or they cancel out.
Cloud mean_normals(const Cloud& cloud, const Cloud& normals, float leaf);

}  // namespace emtr
