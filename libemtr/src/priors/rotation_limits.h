#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

namespace emtr {

/// Angles from middle - half to middle + half, radians, a turn more or less being the same; all of
/// them when half is pi.
struct Arc {
  double middle = 0, half = 3.14159265358979323846;

  bool full() const;
  /// From the middle, in [-pi, pi].
  double offset(double angle) const;
  bool contains(const Arc& other) const;
  /// What both have in common. Two pieces are none of an arc's business: then this one, unchanged.
  /// Nothing when they do not meet.
  std::optional<Arc> intersected(const Arc& other) const;
};

/// Rotations no further than an angle from one of them.
struct RotationBall {
  Eigen::Quaterniond center;
  double radius;  ///< radians
};

/// A rotation as a turn about an axis and then a tilt of that axis: with `across` a unit vector
/// perpendicular to it, q = (cos(tilt/2) cos(angle/2), cos(tilt/2) sin(angle/2) axis +
/// sin(tilt/2) across).
struct SwingTwist {
  double angle, tilt;  ///< radians; tilt in [0, pi]
  Eigen::Vector3d across;

  SwingTwist(const Eigen::Quaterniond& q, const Eigen::Vector3d& axis);
  Eigen::Quaterniond about(const Eigen::Vector3d& axis) const;
};

/// Rotations about one axis, which may lean a little.
struct AxisLimits {
  Eigen::Vector3d axis;  ///< unit
  double tilt;           ///< most of it, radians
  Arc angle;
};

/// A set of rotations: what all the balls and the axis have in common.
class RotationLimits {
 public:
  std::vector<RotationBall> balls;
  std::optional<AxisLimits> axis;

  bool any() const { return !balls.empty() || axis; }

  /// By how much a rotation is outside, radians: of the limit that it breaks most; 0 inside.
  double excess(const Eigen::Quaterniond& q) const;

  /// The nearest rotation within each limit, one after the other: of a single limit the nearest
  /// there is, of several one step of alternating projections.
  Eigen::Quaterniond step(const Eigen::Quaterniond& q) const;

  /// The angles about the axis that the balls leave, and more of them when it may lean; nothing
  /// when they leave none.
  std::optional<Arc> angles() const;

  /// Where it may not lean the balls become limits of the angle: no steps are needed any more.
  /// False when no rotation is left.
  bool simplify();
};

}  // namespace emtr
