// Expresses the limits of a prior as planes in the space of small motions.

#include <cmath>

#include "priors/prior.h"

namespace emtr {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using Limits = std::vector<Prior::Limit>;

constexpr double kPoint = 1e-9;  // a range as narrow as this is a single value

/// Adds the limit whose gradient has these parts for the rotation and the translation.
void add(Limits& out, const Vector3d& rotation, const Vector3d& translation, double room,
         bool equality) {
  const Vector3d &r = rotation, &t = translation;
  out.push_back({{r.x(), r.y(), r.z(), t.x(), t.y(), t.z()}, room, equality});
}

/// Adds the limits of a value from -half to half that is `at` and changes by J x.
void add_range(Limits& out, const Vector3d& rotation, const Vector3d& translation, double at,
               double half) {
  if (half < kPoint) return add(out, rotation, translation, 0, true);
  add(out, rotation, translation, half - at, false);
  add(out, -rotation, -translation, half + at, false);
}

void add_ball(Limits& out, const RotationBall& ball, const Quaterniond& q) {
  if (ball.radius < kPoint) {
    for (int i = 0; i < 3; ++i) add(out, Vector3d::Unit(i), Vector3d::Zero(), 0, true);
    return;
  }
  const Eigen::AngleAxisd d(q * ball.center.conjugate());
  if (d.angle() > kPoint) add(out, d.axis(), Vector3d::Zero(), ball.radius - d.angle(), false);
}

void add_axis(Limits& out, const AxisLimits& limits, const Quaterniond& q) {
  const Vector3d &a = limits.axis, none = Vector3d::Zero();
  const SwingTwist parts(q, a);
  if (limits.tilt < kPoint) {
    const Vector3d u = a.unitOrthogonal();
    add(out, u, none, 0, true);
    add(out, a.cross(u), none, 0, true);
  } else if (parts.tilt > kPoint) {
    add(out, a.cross(q * a).normalized(), none, limits.tilt - parts.tilt, false);
  }
  if (limits.angle.full()) return;
  // J is the gradient of angle = 2 atan2(q.vec . a, q.w), with dq = (w / 2) q.
  const double s = q.w(), p = q.vec().dot(a);
  const Vector3d J = (s * s * a + s * q.vec().cross(a) + p * q.vec()) / (s * s + p * p);
  add_range(out, J, none, limits.angle.offset(parts.angle), limits.angle.half);
}

}  // namespace

Limits Prior::limits(const Rigid& pose) const {
  Limits out;
  const Quaterniond q(pose.R);
  const Vector3d& t = pose.t;
  for (const RotationBall& ball : rotation_.balls) add_ball(out, ball, q);
  if (rotation_.axis) add_axis(out, *rotation_.axis, q);

  // The motion moves a place y by w x y + v: n . (w x y) = w . (y x n).
  const auto along = [&](const Vector3d& n, const Vector3d& y, double at, double half) {
    add_range(out, y.cross(n), n, at, half);
  };
  if (const auto& ball = translation_.ball) {
    const Vector3d d = t - ball->center;
    if (ball->radius < kPoint)
      for (int i = 0; i < 3; ++i) along(Vector3d::Unit(i), t, 0, 0);
    else if (d.norm() > kPoint)
      add(out, t.cross(d.normalized()), d.normalized(), ball->radius - d.norm(), false);
  }
  if (const auto& box = translation_.box) {
    // The matrix's translation t - R lever rotates about the target's center, as t and R do.
    const Vector3d m = t - pose.R * box->lever;
    for (int i = 0; i < 3; ++i)
      along(Vector3d::Unit(i), m, m[i] - (box->low[i] + box->high[i]) / 2,
            (box->high[i] - box->low[i]) / 2);
  }
  return out;
}

}  // namespace emtr
