#pragma once

#include <memory>

#include "neighbors/neighbors.h"

namespace emtr {

/// Puts pcl::KdTreeFLANN behind the interface of our own structures, as the reference.
std::unique_ptr<Neighbors> make_kdtree(const Cloud& cloud, float radius);

}  // namespace emtr
