#pragma once

#include "base_points.h"
#include "extent.h"

namespace emtr {

/// pcl::VoxelGrid of a whole cloud in its unit ball, slab by slab: a slab is a run of whole layers
/// of voxels, so no voxel is cut, and only the slabs at work are ever held as points. With the mean
/// normals of the voxels.
BasePoints thin_by_slabs(const CloudReader& reader, const NormalReader* normals,
                         const Extent& extent, float leaf, int threads);

}  // namespace emtr
