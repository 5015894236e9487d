#pragma once

#include <memory>

#include "neighbors/neighbors.h"

namespace emtr {

/// pcl::KdTreeFLANN behind the interface of our own structures: the reference path.
std::unique_ptr<Neighbors> make_kdtree(const Cloud& cloud, float radius);

}  // namespace emtr
