#include "candidates/rivals.h"

#include "candidates/scene_axes.h"
#include "geometry/pose_distance.h"

namespace emtr {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Returns the rotation by `quarters` times 90 degrees about an axis through a point.
Rigid quarter_rotations(const Vector3d& axis, int quarters, const Vector3d& through) {
  constexpr double cosine[] = {1, 0, -1, 0}, sine[] = {0, 1, 0, -1};
  Matrix3d cross;
  cross << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
  Rigid out;
  out.R = cosine[quarters] * Matrix3d::Identity() + sine[quarters] * cross +
          (1 - cosine[quarters]) * axis * axis.transpose();
  out.t = through - out.rotate(through);
  return out;
}

}  // namespace

std::vector<Rigid> rotated_rivals(const SurfacePair& surfaces, const Rigid& best) {
  const SceneAxes scene = scene_axes(surfaces, best);
  std::vector<Rigid> out;
  for (const Vector3d& axis : scene.axes)
    for (int quarters = 1; quarters < 4; ++quarters)
      for (const Vector3d& through : {scene.mean, scene.middle})
        out.push_back(quarter_rotations(axis, quarters, through) * best);
  return suppress_non_maxima(out, kDuplicatePose, out.size());
}

}  // namespace emtr
