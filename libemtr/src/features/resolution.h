#pragma once

#include "../cloud.h"

namespace emtr {

/// Mean distance of a point to its nearest other point. The cloud has two points or more.
double mean_resolution(const Cloud& cloud);

/// The same bits, faster, for a cloud that was thinned to about one point a cube of side `leaf`;
/// a cloud of any other kind only takes longer.
double mean_resolution(const Cloud& cloud, double leaf, const Kernels& kernels, int threads);

}  // namespace emtr
