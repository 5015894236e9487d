#pragma once

#include "geometry/surface.h"
#include "kernels/kernels.h"

namespace emtr {

constexpr double kNormalReach = 2;  // leaves
constexpr int kMinimumForNormal = 5;

/// Returns the centroids of the voxels of side `leaf` that hold points (those of voxel_grid(),
/// ordered by z, then y, then x), each with the normal of all the cloud's own points in the voxels
/// within `reach` leaves of its own. Finer than normals of the centroids alone, and without a
/// search for neighbors: the voxels are in order, so a row of them is a difference of running sums.
/// A centroid with fewer than `kMinimumForNormal` points about it, or with all of them on one line,
/// has no normal; nor has one where no direction is clearly the thinnest. On normalized clouds
/// only, `leaf` of 2e-3 and more.
Surface downsample_surface(const Cloud& cloud, double leaf, double reach = kNormalReach,
                           const Kernels& kernels = select_kernels());

/// Returns the same centroids with the mean of the user's normals of the points in their own voxel,
/// see mean_normals().
Surface downsample_surface(const Cloud& cloud, const Cloud& normals, double leaf);

}  // namespace emtr
