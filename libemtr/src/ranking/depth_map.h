#pragma once

#include <cstddef>
#include <vector>

#include "geometry/cloud.h"
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

  /// How many of `points`, moved by `pose` into this map's cloud, lie clearly in front of what was
  /// seen: nearer by 2 leaves than all in the 3 x 3 bins about their direction, where at least 6
  /// of these 9 hold something. A bin is a leaf wide at the median range. Behind, or where nothing
  /// was seen, nothing can be said.
  std::size_t in_front(const Cloud& points, const Rigid& pose, Scratch& scratch) const;

 private:
  /// The bins of a face that hold something, in a rectangle: a distant sensor has many bins, and
  /// uses few.
  struct Window {
    std::int32_t left, top, columns, rows;
    std::vector<float> squared;  ///< of the range that is known to be empty
  };

  void fill(const std::vector<DirectionBins::Bin>& bins, const std::vector<float>& ranges,
            std::int32_t face, float margin);

  const Kernels& kernels_;
  DirectionBins bins_;
  Window windows_[6];
};

}  // namespace emtr
