#pragma once

#include "geometry/cloud.h"

namespace emtr {

/// Returns the normals of the planes through the `count` nearest neighbors of each point, by
/// pcl::NormalEstimation; of either sign. A count serves clouds that are sparse in parts, where a
/// radius finds nobody.
Cloud nearest_normals(const Cloud& cloud, int count);

}  // namespace emtr
