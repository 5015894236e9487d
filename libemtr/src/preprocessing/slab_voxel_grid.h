#pragma once

#include "preprocessing/base_points.h"
#include "preprocessing/extent.h"

namespace emtr {

/// pcl::VoxelGrid of a whole cloud in its unit ball, slab by slab: a slab is a run of whole layers
/// of voxels, so no voxel is cut, and only the slabs at work are ever held as points. With the mean
/// normals of the voxels.
BasePoints voxel_grid_by_slabs(const CloudReader& reader, const NormalReader* normals,
                         const Extent& extent, float leaf, int threads);

}  // namespace emtr
