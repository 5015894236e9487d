#include "priors/translation_limits.h"

#include <algorithm>

namespace emtr {
namespace {

using Eigen::Vector3d;

constexpr double kRounding = 1e-14;  // as a share of the numbers

Vector3d clamped(const Vector3d& v, const Vector3d& low, const Vector3d& high) {
  return v.cwiseMax(low).cwiseMin(high);
}

}  // namespace

double TranslationLimits::excess(const Eigen::Matrix3d& R, const Vector3d& t) const {
  double maximum = 0;
  if (ball) maximum = std::max(maximum, (t - ball->center).norm() - ball->radius);
  if (box) {
    const Vector3d m = t - R * box->lever;
    // Each bound has its own rounding: a far one must not blur a near one.
    const auto beyond = [](const Vector3d& by, const Vector3d& bound) {
      return (by - kRounding * bound.cwiseAbs()).maxCoeff();
    };
    maximum = std::max({maximum, beyond(m - box->high, box->high), beyond(box->low - m, box->low)});
  }
  return maximum;
}

Vector3d TranslationLimits::nearest(const Eigen::Matrix3d& R, const Vector3d& t) const {
  if (!box) {
    if (!ball) return t;
    const Vector3d d = t - ball->center;
    return d.norm() <= ball->radius ? t : Vector3d(ball->center + ball->radius * d.normalized());
  }
  const Vector3d offset = R * box->lever, low = box->low + offset, high = box->high + offset;
  if (!ball) return clamped(t, low, high);
  // The nearest point of both lies, clamped, on the way to the ball's center, as far along as the
  // ball requires (the conditions of Kuhn and Tucker).
  const auto at = [&](double s) { return clamped((1 - s) * t + s * ball->center, low, high); };
  const auto inside = [&](double s) { return (at(s) - ball->center).norm() <= ball->radius; };
  if (inside(0)) return at(0);
  double out = 0, in = 1;
  for (int k = 0; k < 60; ++k) (inside((out + in) / 2) ? in : out) = (out + in) / 2;
  return at(in);
}

Eigen::Quaterniond TranslationLimits::step(const Eigen::Quaterniond& q) const {
  if (!ball || !box || box->lever.isZero(0)) return q;
  // Moves R lever so that the ball's center less R lever is within the ball's radius of the box.
  const Vector3d lever = q * box->lever, gap = ball->center - lever,
                 off = gap - clamped(gap, box->low, box->high);
  const double distance = off.norm();
  if (distance <= ball->radius) return q;
  const Vector3d wanted = lever + (1 - ball->radius / distance) * off;
  return (Eigen::Quaterniond::FromTwoVectors(lever, wanted) * q).normalized();
}

double TranslationLimits::rounding() const {
  double largest = 1;
  if (ball) largest = std::max(largest, ball->center.cwiseAbs().maxCoeff());
  if (box) largest = std::max(largest, box->lever.cwiseAbs().maxCoeff());
  return kRounding * largest;
}

}  // namespace emtr
