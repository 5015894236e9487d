#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "geometry/cloud.h"
#include "preprocessing/cloud_reader.h"
#include "preprocessing/extent.h"

namespace emtr {

/// The points of a cloud that came with descriptors. Of more than `kThinnedAbove` only one in each
/// cube, as far smaller than those of the densities as the base points' cubes are.
struct Keypoints {
  Cloud points;                    ///< (p - center) / radius
  std::size_t dimension = 0;       ///< numbers of a descriptor, 0: the cloud came without
  std::vector<float> descriptors;  ///< (n, dimension), finite
  std::vector<std::int32_t> rows;  ///< of the caller's array, ascending

  explicit operator bool() const { return dimension != 0; }
};

/// Points without coordinates or with a descriptor that is not finite are left out. Throws Error,
/// naming the cloud, on features that cannot be read or that no point has.
Keypoints keypoints(const emtr_cloud& cloud, const CloudReader& reader,
                                 const Extent& extent, const std::string& name);

/// One of each cube of side `leaf` (see one_row_per_voxel()).
Keypoints thinned(const Keypoints& described, float leaf);

}  // namespace emtr
