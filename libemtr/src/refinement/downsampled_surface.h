#pragma once

#include "geometry/surface.h"

namespace emtr {

/// The centroids of the cubes of side `leaf` that hold points (the cubes of voxel_grid(), ordered
/// by z, then y, then x), each with the normal of all the cloud's own points in the cubes within
/// `reach` leaves of its own. Finer than normals of the centroids alone, and without a search for
/// neighbors: the cubes are in order, so a row of them is a difference of running sums.
/// A centroid with fewer than `kLeastForNormal` points about it, or with all of them on one line,
/// has no normal. On normalized clouds only, `leaf` of 2e-3 and more.
Surface downsample_surface(const Cloud& cloud, double leaf, double reach = 2.0);

/// The same centroids with the mean of the normals given for the points of their own cube, see
/// mean_normals().
Surface downsample_surface(const Cloud& cloud, const Cloud& normals, double leaf);

constexpr int kLeastForNormal = 5;

}  // namespace emtr
