#pragma once

#include <Eigen/Geometry>
#include <optional>

namespace emtr {

/// Places of the source's centroid no further than a distance from one of them.
struct TranslationBall {
  Eigen::Vector3d center;
  double radius;
};

/// A box for the translation of the user's matrix, which is t - R lever but for a shift that the
/// corners have in them: the lever is the source's centroid in the user's frame.
struct TranslationBox {
  Eigen::Vector3d low, high, lever;
};

/// A set of translations t, for each rotation R another one when there is a box. Normalized frame.
class TranslationLimits {
 public:
  std::optional<TranslationBall> ball;
  std::optional<TranslationBox> box;

  bool any() const { return ball || box; }

  /// By how much t is outside, radii: of the limit that it breaks most; 0 inside.
  double excess(const Eigen::Matrix3d& R, const Eigen::Vector3d& t) const;

  /// The nearest t inside; where ball and box have nothing in common at this R, the point of the
  /// box that is nearest to the ball.
  Eigen::Vector3d nearest(const Eigen::Matrix3d& R, const Eigen::Vector3d& t) const;

  /// A rotation nearby at which ball and box meet: one step of alternating projections.
  Eigen::Quaterniond step(const Eigen::Quaterniond& q) const;

  /// What rounding alone may do to a translation.
  double rounding() const;
};

}  // namespace emtr
