#pragma once

#include <Eigen/Core>
#include <vector>

#include "candidates/surface_pair.h"
#include "geometry/rigid.h"

namespace emtr {

/// The axes about which a scene may look alike: those of both clouds laid together by a pose, in
/// the target's frame.
struct SceneAxes {
  /// The principal axes, and the normal that most of the target's points share where it is not
  /// parallel to one of them. Unit length.
  std::vector<Eigen::Vector3d> axes;
  Eigen::Vector3d mean, middle;  ///< centroid; middle of the box along the principal axes
};

SceneAxes scene_axes(const SurfacePair& surfaces, const Rigid& pose);

}  // namespace emtr
