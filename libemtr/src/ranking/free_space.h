#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/surface.h"
#include "ranking/depth_map.h"
#include "ranking/viewpoint.h"

namespace emtr {

/// Measures how much a pose contradicts the scans: points of one cloud where the sensor of the
/// other looked through nothing.
class FreeSpace {
 public:
  using Scratch = DepthMap::Scratch;

  /// Clouds with a flag for each point that lies on the other: it is no contradiction.
  struct Points {
    const Cloud& cloud;
    const std::vector<std::uint8_t>& inlier;
  };

  /// The kernels must outlive this.
  FreeSpace(const Surface& source, const Surface& target,
            const std::optional<Viewpoint>& source_viewpoint,
            const std::optional<Viewpoint>& target_viewpoint, const Kernels& kernels);

  /// Returns the mean of two shares, 0 to 1: that of each cloud's points that lie clearly in front
  /// of what the other's sensor saw, times the trust in that sensor's place. 0 for a cloud whose
  /// counterpart has no viewpoint.
  double violation(const Points& source, const Points& target, const Rigid& pose,
                   Scratch& scratch) const;

 private:
  struct Seen {
    DepthMap map;
    double trust;
  };
  static std::optional<Seen> seen(const Surface& surface, const std::optional<Viewpoint>& viewpoint,
                                  const Kernels& kernels);

  const std::optional<Seen> by_source_, by_target_;
};

}  // namespace emtr
