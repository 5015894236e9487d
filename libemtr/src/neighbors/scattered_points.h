#pragma once

#include <cstddef>
#include <vector>

#include "geometry/cloud.h"

namespace emtr {

/// Returns, in ascending order, the rows of the points that lie on a surface. The others are
/// scattered in space: their eight nearest neighbors are on average farther away than 1.6 times the
/// cloud's median, and lie on no plane. Sparse parts of a scan are kept, since their neighbors do.
/// Returns all rows when less than a tenth of the points are scattered, since noise has some too,
/// and when most of the others lie on no surface either.
std::vector<std::size_t> rows_on_surface(const Cloud& cloud);

}  // namespace emtr
