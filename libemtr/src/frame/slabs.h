#pragma once

#include "../cloud.h"
#include "cloud_reader.h"
#include "extent.h"

namespace emtr {

/// pcl::VoxelGrid of a whole cloud in its unit ball, slab by slab: a slab is a run of whole layers
/// of voxels, so no voxel is cut, and only the slabs at work are ever held as points.
Cloud thin_by_slabs(const CloudReader& reader, const Extent& extent, float leaf, int threads);

}  // namespace emtr
