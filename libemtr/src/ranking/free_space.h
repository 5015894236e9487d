#pragma once

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

  /// The normals must be oriented (orient_normals()) to the first viewpoint of each surface that
  /// has any. The surfaces and the kernels must outlive this.
  FreeSpace(const Surface& source, const Surface& target, const Viewpoints& source_viewpoints,
            const Viewpoints& target_viewpoints, const Kernels& kernels);

  /// Returns the mean of the shares of both clouds' points that lie clearly in front of what the
  /// other's sensor saw, 0 to 1; 0 for a cloud whose counterpart has no viewpoint.
  ///
  /// `sign`: that of the normals under this pose (SurfaceFitValue::sign). Both sensors saw the same
  /// side of the surface where it is positive, so that first goes with first and mirrored with
  /// mirrored; first with mirrored where it is negative. The minimum of those combinations counts.
  /// Where only one surface has viewpoints, where both are given, or where the sign is 0, all are
  /// tried.
  double violation(const Rigid& pose, double sign, Scratch& scratch) const {
    return violation(source_.points, target_.points, pose, sign, scratch);
  }
  /// Returns the same for a part of both clouds' points.
  double violation(const Cloud& source, const Cloud& target, const Rigid& pose, double sign,
                   Scratch& scratch) const;

 private:
  const Surface& source_;
  const Surface& target_;
  std::vector<DepthMap> source_maps_, target_maps_;
};

}  // namespace emtr
