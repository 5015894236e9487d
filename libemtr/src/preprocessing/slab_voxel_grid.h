#pragma once

#include "preprocessing/base_points.h"
#include "preprocessing/extent.h"

namespace emtr {

/// Applies voxel_grid(), mean_normals() and mean_colors() to a whole cloud in its unit ball, slab
/// by slab. A slab is a run of whole layers of voxels, so it cuts no voxel, and memory holds the
/// points of only those slabs that threads work on.
BasePoints voxel_grid_by_slabs(const CloudReader& reader, const PointData& data,
                               const Extent& extent, float leaf, int threads);

}  // namespace emtr
