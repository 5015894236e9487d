#pragma once

#include <cstddef>

#include "geometry/cloud.h"

namespace emtr {

/// Mean distance of a point to its nearest other point.
double mean_resolution(const Cloud& cloud);

/// Mean distance of a point to its nearest point at another place, so that points given twice do
/// not count; over every k-th point only, with the k that asks for `most` points or a few more.
double mean_spacing(const Cloud& cloud, std::size_t most);

/// The same bits, faster, for a cloud that was thinned to about one point a cube of side `leaf`;
/// a cloud of any other kind only takes longer.
double mean_resolution(const Cloud& cloud, double leaf, const Kernels& kernels, int threads);

}  // namespace emtr
