#pragma once

#include <Eigen/Geometry>
#include <optional>

namespace emtr {

/// All places of the source's centroid within a distance of a given one.
struct TranslationBall {
  Eigen::Vector3d center;
  double radius;
};

/// A box for the translation of the user's matrix, which is t - R lever but for an offset that the
/// corners contain: the lever is the source's centroid in the user's frame.
struct TranslationBox {
  Eigen::Vector3d low, high, lever;
};

/// A set of translations t in the normalized frame; it depends on the rotation R when there is a
/// box.
class TranslationLimits {
 public:
  std::optional<TranslationBall> ball;
  std::optional<TranslationBox> box;

  bool any() const { return ball || box; }

  /// Returns by how much t breaks the limit that it breaks most, radii; 0 inside.
  double excess(const Eigen::Matrix3d& R, const Eigen::Vector3d& t) const;

  /// Returns the nearest t inside; where ball and box have nothing in common at this R, the point
  /// of the box that is nearest to the ball.
  Eigen::Vector3d nearest(const Eigen::Matrix3d& R, const Eigen::Vector3d& t) const;

  /// Returns a rotation nearby at which ball and box meet: one step of alternating projections.
  Eigen::Quaterniond step(const Eigen::Quaterniond& q) const;

  /// Returns by how much rounding alone may change a translation.
  double rounding() const;
};

}  // namespace emtr
