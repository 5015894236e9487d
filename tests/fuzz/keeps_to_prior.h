#pragma once

#include <emtr/emtr.h>

#include <Eigen/Geometry>
#include <cmath>

#include "input.h"

namespace fuzz {

/// Checks poses against the priors of some settings, by other formulas than the library's, with a
/// tolerance for what rounding does to a pose of clouds of their size at their places.
class KeptPrior {
 public:
  KeptPrior(const emtr_settings& settings, const emtr_result& result)
      : s_(settings), center_(Eigen::Vector3d::Map(result.center_source)) {
    rounding_ =
        1e-9 * result.normalization_scale + 1e-12 * (center_.norm() + size(result.center_target));
  }

  void require_kept(const double (&transformation)[16]) const {
    const Matrix T = Matrix::Map(transformation);
    const Eigen::Matrix3d R = T.topLeftCorner<3, 3>();
    const Eigen::Vector3d t = T.topRightCorner<3, 1>();
    if (s_.has_guess) require_near_guess(R, t);
    if (s_.has_axis) require_about_axis(R);
    if (s_.maximum_rotation < 180) require(degrees(R) <= s_.maximum_rotation + kTiny);
    if (!s_.has_translation_bounds) return;
    const double off = rounding_ + 1e-12 * t.norm();
    for (int k = 0; k < 3; ++k)
      require(t[k] >= s_.translation_minimum[k] - off && t[k] <= s_.translation_maximum[k] + off);
  }

 private:
  using Matrix = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;
  static constexpr double kTiny = 1e-6;  // degrees
  static constexpr double kDegree = M_PI / 180;

  static double size(const double (&v)[3]) { return Eigen::Vector3d::Map(v).stableNorm(); }

  /// Returns the angle of a rotation, which is exact near 0 and near 180 too.
  static double degrees(const Eigen::Matrix3d& R) {
    const Eigen::Quaterniond q = Eigen::Quaterniond(R).normalized();
    return 2 * std::atan2(q.vec().norm(), std::abs(q.w())) / kDegree;
  }

  void require_near_guess(const Eigen::Matrix3d& R, const Eigen::Vector3d& t) const {
    const Matrix G = Matrix::Map(s_.guess);
    const Eigen::Matrix3d guess(
        Eigen::Quaterniond(Eigen::Matrix3d(G.topLeftCorner<3, 3>())).normalized());
    if (s_.guess_rotation < 180)
      require(degrees(R * guess.transpose()) <= s_.guess_rotation + kTiny);
    if (s_.guess_translation >= 1e12) return;
    const Eigen::Vector3d to = G.topLeftCorner<3, 3>() * center_ + G.topRightCorner<3, 1>();
    const double off = rounding_ + 1e-12 * (t.norm() + G.topRightCorner<3, 1>().norm());
    require((R * center_ + t - to).norm() <= s_.guess_translation * (1 + 1e-12) + off);
  }

  void require_about_axis(const Eigen::Matrix3d& R) const {
    const Eigen::Vector3d a = Eigen::Vector3d::Map(s_.axis).stableNormalized(), b = R * a;
    require(std::atan2(a.cross(b).norm(), a.dot(b)) / kDegree <= s_.axis_tilt + kTiny);
    const double half = (s_.axis_angle_maximum - s_.axis_angle_minimum) / 2;
    if (half >= 180) return;
    const Eigen::Quaterniond q(R);
    const double angle = 2 * std::atan2(q.vec().dot(a), q.w()) / kDegree;
    const double middle = (s_.axis_angle_maximum + s_.axis_angle_minimum) / 2;
    require(std::abs(std::remainder(angle - middle, 360)) <= half + kTiny);
  }

  const emtr_settings& s_;
  Eigen::Vector3d center_;
  double rounding_;
};

}  // namespace fuzz
