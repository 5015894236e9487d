#include "refinement/unconstrained_motion.h"

#include <cmath>

#include "geometry/pose_distance.h"
#include "geometry/rotation_vector.h"

namespace emtr {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Returns the screw of a motion: the rotation vector w and the v with exp(w, v) = the motion,
/// whose translation is that of the point it is about.
void screw(const Matrix3d& R, const Vector3d& translation, Vector3d& w, Vector3d& v) {
  w = logarithm(Eigen::Quaterniond(R));
  const double angle = w.norm();
  Matrix3d cross;
  cross << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
  // The inverse of the left Jacobian of SO(3); its last factor is 1 / 12 at angle 0.
  const double factor =
      angle < 1e-4 ? 1.0 / 12 : 1 / (angle * angle) - 1 / (2 * angle * std::tan(angle / 2));
  v = (Matrix3d::Identity() - 0.5 * cross + factor * cross * cross) * translation;
}

}  // namespace

bool is_same_but_unconstrained(const Rigid& a, const Rigid& b, const HessianSpectrum& spectrum) {
  const Matrix3d R = a.R * b.R.transpose();
  const Vector3d center = Vector3d::Map(spectrum.center);
  const Vector3d translation = R * (center - b.t) + a.t - center;
  Vector3d w, v;
  screw(R, translation, w, v);
  Eigen::Matrix<double, 6, 1> motion;
  motion << w * spectrum.radius, v;
  for (int k = 0; k < spectrum.unconstrained; ++k) {
    const auto direction = Eigen::Map<const Eigen::Matrix<double, 6, 1>>(spectrum.eigenvectors[k]);
    motion -= direction * direction.dot(motion);
  }
  return motion.head<3>().norm() <= kDistinctPose.angle * spectrum.radius &&
         motion.tail<3>().norm() <= kDistinctPose.translation;
}

}  // namespace emtr
