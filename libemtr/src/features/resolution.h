#pragma once

#include "../cloud.h"

namespace emtr {

/// Mean distance of a point to its nearest other point.
double mean_resolution(const Cloud& cloud);

}  // namespace emtr
