#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/cloud.h"
#include "ranking/cube_map.h"
#include "ranking/direction_bins.h"

namespace emtr {

/// What a sensor saw: for each direction, how far it is known to have looked through nothing.
class DepthMap {
 public:
  /// `points`: at least one, as seen from `viewpoint`, spaced by `leaf`.
  DepthMap(const Cloud& points, const double viewpoint[3], double leaf, const Kernels& kernels);

  struct Scratch {
    std::vector<float> x, y, z;
  };

  /// Counts the points that, moved by `pose` into this map's cloud, lie clearly in front of what
  /// was seen: nearer by 0.7 leaves than all in the 3 x 3 bins about their direction, where at
  /// least 6 of these 9 hold something. A bin is a leaf wide at the median range. Behind, or where
  /// nothing was seen, nothing can be said.
  /// Leaves out the points that `inlier` marks, one entry each; it may be null.
  std::size_t in_front(const Cloud& points, const Rigid& pose, Scratch& scratch,
                       const std::uint8_t* inlier = nullptr) const;

 private:
  using Bins = std::vector<DirectionBins::Bin>;
  std::vector<float> nearest_ranges(const Bins& bins, const std::vector<float>& ranges) const;
  void find_free_ranges(const CubeMap::Window& window, const std::vector<float>& nearest,
                        float margin);

  const Kernels& kernels_;
  DirectionBins bins_;
  CubeMap map_;
  std::vector<float> squared_free_range_;  // by bin: squared length of the ray known to be empty
};

}  // namespace emtr
