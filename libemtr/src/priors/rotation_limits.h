#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "util/constants.h"

namespace emtr {

/// Angles from middle - half to middle + half, radians, modulo a full rotation; all angles when
/// half is pi.
struct Arc {
  double middle = 0, half = kPi;

  bool full() const;
  /// Returns the angle from the middle, in [-pi, pi].
  double offset(double angle) const;
  bool contains(const Arc& other) const;
  /// Returns what both have in common, or nothing when they do not meet. Returns this arc unchanged
  /// where the common angles are two pieces, which no arc can hold.
  std::optional<Arc> intersected(const Arc& other) const;
};

/// All rotations within an angle of a given one.
struct RotationBall {
  Eigen::Quaterniond center;
  double radius;  ///< radians
};

/// A rotation split into a rotation about an axis (the twist) and then a tilt of that axis (the
/// swing): with `across` a unit vector perpendicular to it, q = (cos(tilt/2) cos(angle/2),
/// cos(tilt/2) sin(angle/2) axis + sin(tilt/2) across).
struct SwingTwist {
  double angle, tilt;  ///< radians; tilt in [0, pi]
  Eigen::Vector3d across;

  SwingTwist(const Eigen::Quaterniond& q, const Eigen::Vector3d& axis);
  Eigen::Quaterniond about(const Eigen::Vector3d& axis) const;
};

/// Rotations about one axis, which may tilt a little.
struct AxisLimits {
  Eigen::Vector3d axis;  ///< unit
  double tilt;           ///< maximum, radians
  Arc angle;
};

/// A set of rotations: those within all the balls and the limits of the axis.
class RotationLimits {
 public:
  std::vector<RotationBall> balls;
  std::optional<AxisLimits> axis;

  bool any() const { return !balls.empty() || axis; }

  /// Returns by how much a rotation breaks the limit that it breaks most, radians; 0 inside.
  double excess(const Eigen::Quaterniond& q) const;

  /// Returns the nearest rotation within each limit, one after the other: the projection onto a
  /// single limit, or one step of alternating projections onto several.
  Eigen::Quaterniond step(const Eigen::Quaterniond& q) const;

  /// Returns the angles about the axis that the balls leave, and somewhat more when it may tilt;
  /// nothing when they leave none.
  std::optional<Arc> angles() const;

  /// Turns the balls into limits of the angle where the axis may not tilt: projections then need no
  /// steps. Returns false when no rotation is left.
  bool simplify();
};

}  // namespace emtr
