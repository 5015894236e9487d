#include "verdict/symmetry.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "geometry/pose_distance.h"
#include "geometry/rotation_vector.h"

namespace emtr {
namespace {

using Eigen::Vector3d;

constexpr double kSymmetricShare = 0.84;     // of the best score
constexpr double kParallel = 0.985;          // cosine of 10 degrees
constexpr double kMultiple = 4 * kPi / 180;  // how far a rotation may be from one by 360 / n
constexpr int kHighestOrder = 36;            // 10 degrees, the least between two answers
constexpr double kMostlyRotation = 0.7;      // of a unit direction

/// A rival's motion from the best candidate, in the target's frame.
struct Difference {
  double angle;       ///< of the rotation, radians
  Vector3d axis;      ///< of the rotation
  double along;       ///< translation along that axis
  Vector3d distance;  ///< of the source's centroid
};

std::vector<Difference> differences(const Candidate& best,
                                    const std::vector<Candidate>& alternatives) {
  std::vector<Difference> out;
  for (const Candidate& other : alternatives) {
    if (other.score < kSymmetricShare * best.score) break;
    const Rigid motion = other.pose * best.pose.inverse();
    const Vector3d w = logarithm(Eigen::Quaterniond(motion.R));
    const Vector3d axis = w.norm() > 0 ? Vector3d(w.normalized()) : Vector3d::UnitZ();
    out.push_back({w.norm(), axis, std::abs(motion.t.dot(axis)), other.pose.t - best.pose.t});
  }
  return out;
}

bool is_rotation(const Difference& d) {
  return d.angle > kDistinctPose.angle && d.along < kDistinctPose.translation;
}

bool is_translation(const Difference& d) { return d.angle <= kDistinctPose.angle; }

bool parallel(const Vector3d& a, const Vector3d& b) {
  return std::abs(a.dot(b)) > kParallel * a.norm() * b.norm();
}

/// Returns the smallest n of whose steps, 360 / n degrees, all angles are multiples; 0: none is.
int order_of(const std::vector<double>& angles) {
  for (int n = 2; n <= kHighestOrder; ++n) {
    const double step = 2 * kPi / n;
    if (std::all_of(angles.begin(), angles.end(), [&](double angle) {
          return std::abs(angle - step * std::round(angle / step)) < kMultiple;
        }))
      return n;
  }
  return 0;
}

Symmetry rotational(const Vector3d& axis, const std::vector<Difference>& all) {
  std::vector<double> angles;
  for (const Difference& d : all)
    if (is_rotation(d) && parallel(d.axis, axis)) angles.push_back(d.angle);
  Symmetry out;
  out.order = order_of(angles);
  if (out.order == 0) return {};
  out.kind = Symmetry::Rotational;
  out.axis = axis;
  return out;
}

Symmetry translational(const Vector3d& distance, const std::vector<Difference>& all) {
  Symmetry out;
  out.kind = Symmetry::Translational;
  out.axis = distance.normalized();
  out.period = distance.norm();
  for (const Difference& d : all)
    if (is_translation(d) && parallel(d.distance, distance))
      out.period = std::min(out.period, d.distance.norm());
  return out;
}

/// Prefers the rotation where both kinds of motion are unconstrained, as those of a cylinder.
Symmetry unconstrained(const HessianSpectrum& spectrum) {
  Eigen::MatrixXd rotations(3, spectrum.unconstrained), translations(3, spectrum.unconstrained);
  for (int k = 0; k < spectrum.unconstrained; ++k) {
    rotations.col(k) = Vector3d::Map(spectrum.eigenvectors[k]);
    translations.col(k) = Vector3d::Map(spectrum.eigenvectors[k] + 3);
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd> of_rotations(rotations, Eigen::ComputeThinU);
  Symmetry out;
  if (of_rotations.singularValues()[0] > kMostlyRotation) {
    out.kind = Symmetry::Continuous;
    out.axis = of_rotations.matrixU().col(0);
    return out;
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd> of_translations(translations, Eigen::ComputeThinU);
  out.kind = Symmetry::Translational;
  out.axis = of_translations.matrixU().col(0);
  out.period = 0;
  return out;
}

}  // namespace

const char* name_of(Symmetry::Kind kind) {
  switch (kind) {
    case Symmetry::None:
      return "none";
    case Symmetry::Rotational:
      return "rotational";
    case Symmetry::Continuous:
      return "continuous";
    case Symmetry::Translational:
      return "translational";
  }
  return "none";
}

Symmetry find_symmetry(const Candidate& best, const std::vector<Candidate>& alternatives,
                       const HessianSpectrum* spectrum) {
  if (spectrum && spectrum->unconstrained > 0 && spectrum->unconstrained < 6)
    return unconstrained(*spectrum);
  const std::vector<Difference> all = differences(best, alternatives);
  for (const Difference& d : all) {
    if (is_rotation(d)) return rotational(d.axis, all);
    if (is_translation(d)) return translational(d.distance, all);
  }
  return {};
}

}  // namespace emtr
