#pragma once

#include "geometry/cloud.h"
#include "preprocessing/cloud_reader.h"
#include "preprocessing/extent.h"

namespace emtr {

/// A cloud of more points than this is thinned before anything else is done with it.
constexpr std::size_t kThinnedAbove = 200000;
constexpr float kBaseLeaf = 0.004f;  ///< radii; some tenth of the dense leaf

/// The caller's normals, of any length; null when there are none.
using NormalReader = CloudReader;

struct BasePoints {
  Cloud points;
  Cloud normals;  ///< of unit length, one a point, NaN where there is none; empty without any
};

/// All finite points in the unit ball about their centroid, in order.
BasePoints all_points(const CloudReader& reader, const NormalReader* normals, const Extent& extent,
                      int threads);

/// All of them or, of a large cloud, what pcl::VoxelGrid leaves of them at a leaf that keeps at
/// most about a million, with the mean normals of its cubes.
BasePoints base_points(const CloudReader& reader, const NormalReader* normals, const Extent& extent,
                       int threads);

}  // namespace emtr
