#pragma once

#include <array>
#include <vector>

#include "geometry/surface.h"

namespace emtr {

/// A place from which a cloud may have been scanned, in the cloud's own normalized frame.
struct Viewpoint {
  double at[3] = {};

  std::array<float, 3> in_float() const {
    return {static_cast<float>(at[0]), static_cast<float>(at[1]), static_cast<float>(at[2])};
  }
};

/// All that is known of where a cloud's sensor stood.
struct Viewpoints {
  /// None: a closed model, or several scans in one. One: given. Two: estimated, and the same place
  /// mirrored in the centroid, as a thin sheet looks the same from behind.
  std::vector<Viewpoint> candidates;
  /// Share of the points that can be seen from the given place, or from the best of those tried,
  /// 0 to 1.
  double visible = 0;
};

/// The share that must be visible for an estimate. In closed models 0.6 to 0.74 is, in scans,
/// several scans fused into one included, more than 0.8.
constexpr double kMinimumVisible = 0.8;

Viewpoints given_viewpoint(const Surface& surface, const Viewpoint& at, const Kernels& kernels);

/// Returns the middle of those places that see most, among 400 around the cloud: 100 directions
/// from its centroid, at radii of 1.26 to 8, the normalized frame's being 1. Not nearer: from
/// inside, a closed model is as visible as a room. The signs of the normals do not matter.
Viewpoints estimate_viewpoints(const Surface& surface, const Kernels& kernels);

}  // namespace emtr
