#pragma once

#include "geometry/cloud.h"

namespace emtr {

/// Returns the centroid of each voxel of side `leaf` that holds points, by pcl::VoxelGrid. Takes
/// normalized clouds only, whose voxels are too few for PCL's indices to overflow.
Cloud voxel_grid(const Cloud& cloud, float leaf);

}  // namespace emtr
