#pragma once

#include "geometry/cloud.h"

namespace emtr {

/// pcl::VoxelGrid: one point, the centroid, for each cube of side `leaf` that holds points.
/// On normalized clouds only, where the count of cubes cannot overflow.
Cloud voxel_grid(const Cloud& cloud, float leaf);

}  // namespace emtr
