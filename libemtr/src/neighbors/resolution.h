#pragma once

#include <cstddef>

#include "geometry/cloud.h"

namespace emtr {

/// Returns the mean distance of a point to its nearest other point.
double mean_resolution(const Cloud& cloud);

/// Returns the mean distance of a point to its nearest point at another place, so that duplicates
/// do not count. Queries every k-th point, with the k that gives `max_count` points or a few more.
double mean_spacing(const Cloud& cloud, std::size_t max_count);

/// Returns the same bits as mean_resolution(cloud), faster for a cloud that was downsampled to
/// about one point for each voxel of side `leaf`. Any other cloud only takes longer.
double mean_resolution(const Cloud& cloud, double leaf, const Kernels& kernels, int threads);

}  // namespace emtr
