#pragma once

#include "geometry/cloud.h"
#include "preprocessing/cloud_reader.h"
#include "preprocessing/color_reader.h"
#include "preprocessing/extent.h"

namespace emtr {

/// A cloud of more points than this is downsampled before anything else is done with it.
constexpr std::size_t kDownsampledAbove = 200000;
constexpr float kBaseLeaf = 0.004f;  ///< radii; about a tenth of the dense leaf

/// Reads the user's normals, of any length.
using NormalReader = CloudReader;

struct BasePoints {
  Cloud points;
  Cloud normals;  ///< one for each point, unit length, NaN where there is none; or empty
  Cloud colors;   ///< one for each point, NaN where there is none; or empty
};

/// What the user provided beside the points; null where there is none.
struct PointData {
  const NormalReader* normals = nullptr;
  const ColorReader* colors = nullptr;
};

/// Returns all finite points, in order, in the unit ball about their centroid.
BasePoints read_all_points(const CloudReader& reader, const PointData& data, const Extent& extent,
                           int threads);

/// Returns all finite points of a small cloud, and the centroids of the voxels of a large one, with
/// their mean normals and colors. The leaf grows until at most about a million are left.
BasePoints read_base_points(const CloudReader& reader, const PointData& data, const Extent& extent,
                            int threads);

}  // namespace emtr
