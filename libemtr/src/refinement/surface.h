#pragma once

#include "../cloud.h"

namespace emtr {

/// A cloud with the directions of its surface, as the local polish takes it. In the normalised
/// frame, in any order.
struct Surface {
  Cloud points;
  Cloud normals;    ///< one a point; of unit length, of any sign, NaN where there is none
  double leaf = 0;  ///< spacing of the points, the unit of the polish's lengths; above 0
};

/// The centroids of the cubes of side `leaf` that hold points (the cubes of voxel_grid(), ordered
/// by z, then y, then x), each with the normal of all the cloud's own points in the cubes within
/// `reach` leaves of its own. Finer than normals of the centroids alone, and without a search for
/// neighbours: the cubes are in order, so a row of them is a difference of running sums.
/// A centroid with fewer than `kLeastForNormal` points about it, or with all of them on one line,
/// has no normal. On normalised clouds only, `leaf` of 2e-3 and more.
Surface thin_surface(const Cloud& cloud, double leaf, double reach = 2.0);

constexpr int kLeastForNormal = 5;

}  // namespace emtr
