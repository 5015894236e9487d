#pragma once

#include "../cloud.h"
#include "cloud_reader.h"
#include "extent.h"

namespace emtr {

/// A cloud of more points than this is thinned before anything else is done with it.
constexpr std::size_t kThinnedAbove = 200000;

/// The finite points in the unit ball about their centroid: all of them in order, or, of a large
/// cloud, what pcl::VoxelGrid leaves of them at a leaf that keeps at most about a million.
Cloud base_points(const CloudReader& reader, const Extent& extent, int threads);

}  // namespace emtr
