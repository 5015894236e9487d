#pragma once

#include <vector>

#include "geometry/cloud.h"
#include "preprocessing/color_reader.h"

namespace emtr {

/// The colors of two clouds made comparable: along the principal axes of all their colors, and in
/// each cloud of mean 0 and variance 1, so that a gain and an offset of the exposure do not count.
/// Beyond kFarthestColor they are cut off. A channel that hardly varies in one of the clouds is 0
/// in both.
struct Channels {
  Cloud source, target;  ///< one entry a point, NaN where it has no color
  bool used[3] = {};

  bool any() const { return used[0] || used[1] || used[2]; }
};

constexpr int kChannels = 3;

/// Returns one channel of all entries.
inline const std::vector<float>& channel(const Cloud& cloud, int k) {
  return k == 0 ? cloud.x : k == 1 ? cloud.y : cloud.z;
}

constexpr float kFarthestColor = 4;  ///< standard deviations

/// Makes channels of what ColorReader reads of the points of both clouds; of intensities, without
/// their fall-off.
Channels make_channels(const Cloud& source, const Cloud& target);

}  // namespace emtr
