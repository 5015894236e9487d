#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "geometry/cloud.h"
#include "preprocessing/cloud_reader.h"
#include "preprocessing/extent.h"

namespace emtr {

/// The points of a cloud that take part in the matching because the user provided descriptors for
/// them or named them in correspondences.
struct Keypoints {
  Cloud points;                    ///< (p - center) / radius or normalized frame
  std::size_t dimension = 0;       ///< numbers of a descriptor; 0 without descriptors
  std::vector<float> descriptors;  ///< (n, dimension), finite
  std::vector<std::int32_t> rows;  ///< in the user's array, ascending

  explicit operator bool() const { return dimension != 0; }
};

/// Reads the points that have finite coordinates and a finite descriptor. Of more than
/// `kDownsampledAbove` it keeps one for each voxel of side `kBaseLeaf`. Throws Error, naming the
/// cloud, on descriptors that cannot be read or that no point has.
Keypoints read_keypoints(const emtr_cloud& cloud, const CloudReader& reader, const Extent& extent,
                         const std::string& name);

/// Returns one keypoint for each voxel of side `leaf`, see one_row_per_voxel().
Keypoints downsample(const Keypoints& keypoints, float leaf);

}  // namespace emtr
