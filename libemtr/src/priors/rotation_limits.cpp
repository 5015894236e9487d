#include "priors/rotation_limits.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace emtr {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kRounding = 1e-12;

double angle_of(const Quaterniond& q) { return 2 * std::atan2(q.vec().norm(), std::abs(q.w())); }

Quaterniond nearest(const RotationBall& ball, const Quaterniond& q) {
  Quaterniond d = q * ball.center.conjugate();
  if (d.w() < 0) d.coeffs() *= -1;
  if (angle_of(d) <= ball.radius) return q;
  const Vector3d direction = d.vec().normalized();
  return Quaterniond(Eigen::AngleAxisd(ball.radius, direction)) * ball.center;
}

/// Maximizes the scalar product with a rotation q of tilt s, angle a and direction u,
///   cos(s/2) cos(s'/2) cos((a - a')/2) + sin(s/2) sin(s'/2) u.u',
/// which is largest for u' = u, the nearest angle, and then tan(s'/2) = tan(s/2) / cos((a - a')/2).
Quaterniond nearest(const AxisLimits& limits, const Quaterniond& q) {
  SwingTwist parts(q, limits.axis);
  const double offset = limits.angle.offset(parts.angle),
               clamped = std::clamp(offset, -limits.angle.half, limits.angle.half);
  // A full rotation more changes the sign of the first two of a quaternion's parts.
  const double full_rotations =
      std::round((limits.angle.middle + offset - parts.angle) / (2 * kPi));
  if (std::fmod(full_rotations, 2) != 0) parts.across = -parts.across;
  parts.angle = limits.angle.middle + clamped;
  const double tilt = 2 * std::atan2(std::sin(parts.tilt / 2),
                                     std::cos(parts.tilt / 2) * std::cos((offset - clamped) / 2));
  parts.tilt = std::min(tilt, limits.tilt);
  return parts.about(limits.axis);
}

/// Returns the angles about the axis that a ball leaves, and somewhat more when the axis may tilt:
/// from the scalar product above at the maximum tilt. Returns nothing when the ball leaves none.
std::optional<Arc> shadow(const RotationBall& ball, const AxisLimits& limits) {
  const SwingTwist center(ball.center, limits.axis);
  const double upright = std::cos(center.tilt / 2);
  const double minimum =
      std::cos(ball.radius / 2) - std::sin(limits.tilt / 2) * std::sin(center.tilt / 2);
  if (minimum <= 0 || upright <= 0) return Arc();
  if (minimum > upright * (1 + kRounding)) return std::nullopt;
  return Arc{center.angle, 2 * std::acos(std::min(1.0, minimum / upright))};
}

}  // namespace

bool Arc::full() const { return half >= kPi; }

double Arc::offset(double angle) const { return std::remainder(angle - middle, 2 * kPi); }

bool Arc::contains(const Arc& other) const {
  return full() || std::abs(offset(other.middle)) + other.half <= half + kRounding;
}

std::optional<Arc> Arc::intersected(const Arc& other) const {
  if (other.full()) return *this;
  if (full()) return other;
  std::optional<Arc> found;
  for (const double full_rotation : {-2 * kPi, 0.0, 2 * kPi}) {
    const double at = offset(other.middle) + full_rotation, low = std::max(-half, at - other.half),
                 high = std::min(half, at + other.half);
    if (low > high + kRounding) continue;
    if (found) return *this;
    found = Arc{middle + (low + high) / 2, std::max(0.0, (high - low) / 2)};
  }
  return found;
}

SwingTwist::SwingTwist(const Quaterniond& q, const Vector3d& axis) {
  const double along = q.vec().dot(axis);
  const Vector3d rest = q.vec() - along * axis;
  const double length = rest.norm();
  angle = 2 * std::atan2(along, q.w());
  tilt = 2 * std::atan2(length, std::hypot(q.w(), along));
  across = length > 0 ? Vector3d(rest / length) : axis.unitOrthogonal();
}

Quaterniond SwingTwist::about(const Vector3d& axis) const {
  const double upright = std::cos(tilt / 2);
  Quaterniond q;
  q.w() = upright * std::cos(angle / 2);
  q.vec() = upright * std::sin(angle / 2) * axis + std::sin(tilt / 2) * across;
  return q;
}

double RotationLimits::excess(const Quaterniond& q) const {
  double maximum = 0;
  for (const RotationBall& ball : balls)
    maximum = std::max(maximum, angle_of(q * ball.center.conjugate()) - ball.radius);
  if (!axis) return maximum;
  const SwingTwist parts(q, axis->axis);
  maximum = std::max(maximum, parts.tilt - axis->tilt);
  if (axis->angle.full()) return maximum;
  return std::max(maximum, std::abs(axis->angle.offset(parts.angle)) - axis->angle.half);
}

Quaterniond RotationLimits::step(const Quaterniond& q) const {
  Quaterniond out = q;
  for (const RotationBall& ball : balls) out = nearest(ball, out);
  if (axis) out = nearest(*axis, out);
  return out.normalized();
}

std::optional<Arc> RotationLimits::angles() const {
  Arc out = axis->angle;
  for (const RotationBall& ball : balls) {
    const auto left = shadow(ball, *axis);
    const auto both = left ? out.intersected(*left) : std::nullopt;
    if (!both) return std::nullopt;
    out = *both;
  }
  return out;
}

bool RotationLimits::simplify() {
  if (!axis) return true;
  const auto left = angles();
  if (!left) return false;
  if (axis->tilt > 0) return true;
  axis->angle = *left;
  const auto settled = [this](const RotationBall& ball) {
    return shadow(ball, *axis)->contains(axis->angle);
  };
  balls.erase(std::remove_if(balls.begin(), balls.end(), settled), balls.end());
  return true;
}

}  // namespace emtr
