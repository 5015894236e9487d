#pragma once

#include <cstddef>

#include "../cloud.h"

namespace emtr {

/// pcl::VoxelGrid: one point, the centroid, for each cube of side `leaf` that holds points.
/// On normalised clouds only, where the count of cubes cannot overflow.
Cloud voxel_grid(const Cloud& cloud, float leaf);

/// How many points voxel_grid() would return, without making them.
std::size_t count_voxels(const Cloud& cloud, float leaf);

}  // namespace emtr
