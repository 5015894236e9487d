#pragma once

#include <vector>

#include "geometry/surface.h"

namespace emtr {

/// A place from which a cloud may have been scanned, in the cloud's own normalized frame.
struct Viewpoint {
  double at[3] = {};
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

/// The share that must be visible for an estimate. Of closed models 0.6 to 0.74 is, of scans,
/// several frames fused into one included, more than 0.8.
constexpr double kLeastVisible = 0.8;

Viewpoints given_viewpoint(const Surface& surface, const Viewpoint& at, const Kernels& kernels);

/// The middle of those places that see most, of 400 around the cloud: 100 directions from its
/// centroid, at radii of 1.26 to 8, the normalized frame's being 1. Not nearer: from inside, a
/// closed model is as visible as a room. The signs of the normals do not matter.
Viewpoints estimate_viewpoints(const Surface& surface, const Kernels& kernels);

/// Turns each normal to the side of the viewpoint.
void orient(Surface& surface, const Viewpoint& toward);

}  // namespace emtr
