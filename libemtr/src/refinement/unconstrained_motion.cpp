#include "refinement/unconstrained_motion.h"

#include <cmath>

#include "geometry/pose_distance.h"
#include "geometry/rotation_vector.h"

namespace emtr {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// A motion exp(w, v) about a point: v is the translation of the point on the way.
struct Screw {
  Vector3d w, v;
};

/// Returns the screw from b to a about the center.
Screw screw(const Rigid& a, const Rigid& b, const Vector3d& center) {
  const Matrix3d R = a.R * b.R.transpose();
  const Vector3d w = logarithm(Eigen::Quaterniond(R));
  const double angle = w.norm();
  const Matrix3d K = cross_matrix(w);
  // The inverse of the left Jacobian of SO(3); its last factor is 1 / 12 at angle 0.
  const double factor =
      angle < 1e-4 ? 1.0 / 12 : 1 / (angle * angle) - 1 / (2 * angle * std::tan(angle / 2));
  const Vector3d translation = R * (center - b.t) + a.t - center;
  return {w, (Matrix3d::Identity() - 0.5 * K + factor * K * K) * translation};
}

}  // namespace

bool is_same_but_unconstrained(const Rigid& a, const Rigid& b, const HessianSpectrum& spectrum) {
  const Screw s = screw(a, b, Vector3d::Map(spectrum.center));
  Eigen::Matrix<double, 6, 1> motion;
  motion << s.w * spectrum.radius, s.v;
  for (int k = 0; k < spectrum.unconstrained; ++k) {
    const auto direction = Eigen::Map<const Eigen::Matrix<double, 6, 1>>(spectrum.eigenvectors[k]);
    motion -= direction * direction.dot(motion);
  }
  return motion.head<3>().norm() <= kDistinctPose.angle * spectrum.radius &&
         motion.tail<3>().norm() <= kDistinctPose.translation;
}

Rigid between(const Rigid& a, const Rigid& b, const HessianSpectrum& spectrum, double fraction) {
  const Vector3d center = Vector3d::Map(spectrum.center);
  const Screw s = screw(a, b, center);
  const Vector3d w = fraction * s.w;
  const double angle = w.norm();
  const Matrix3d K = cross_matrix(w);
  // The left Jacobian; its factors are 1 / 2 and 1 / 6 at angle 0.
  const double first = angle < 1e-4 ? 0.5 : (1 - std::cos(angle)) / (angle * angle);
  const double second = angle < 1e-4 ? 1.0 / 6 : (angle - std::sin(angle)) / std::pow(angle, 3);
  const Vector3d translation = (Matrix3d::Identity() + first * K + second * K * K) * fraction * s.v;
  Rigid motion;
  motion.R = exponential(w).toRotationMatrix();
  motion.t = center + translation - motion.rotate(center);
  return motion * b;
}

}  // namespace emtr
