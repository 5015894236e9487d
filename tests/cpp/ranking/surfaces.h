#pragma once

#include <array>
#include <cmath>
#include <random>

#include "geometry/rigid.h"
#include "geometry/surface.h"
#include "support/clouds.h"

namespace emtr_test {

using Vector = std::array<double, 3>;

inline double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline void push(emtr::Surface& surface, const Vector& p, const Vector& n) {
  const auto f = [](double v) { return static_cast<float>(v); };
  push(surface.points, f(p[0]), f(p[1]), f(p[2]));
  push(surface.normals, f(n[0]), f(n[1]), f(n[2]));
}

inline Vector point(const emtr::Cloud& cloud, std::size_t i) {
  return {double{cloud.x[i]}, double{cloud.y[i]}, double{cloud.z[i]}};
}

/// Returns R v + t; R v when `direction`.
inline Vector carry(const emtr::Rigid& T, const Vector& v, bool direction = false) {
  const Eigen::Vector3d p(v[0], v[1], v[2]), q = direction ? T.rotate(p) : T * p;
  return {q[0], q[1], q[2]};
}

inline emtr::Surface moved(const emtr::Surface& surface, const emtr::Rigid& T) {
  emtr::Surface out;
  out.leaf = surface.leaf;
  for (std::size_t i = 0; i < surface.points.size(); ++i)
    push(out, carry(T, point(surface.points, i)), carry(T, point(surface.normals, i), true));
  return out;
}

/// Returns the motion that applies b and then a.
inline emtr::Rigid compose(const emtr::Rigid& a, const emtr::Rigid& b) { return a * b; }

/// A lumpy ball about the origin, radius 0.5 to 0.9, as a function of the direction: smooth, and
/// without symmetry.
inline double lump_radius(const Vector& u) {
  return 0.7 + 0.08 * std::sin(3 * u[0] + 1) + 0.06 * std::sin(5 * u[1] - 2 * u[2]) +
         0.05 * std::cos(4 * u[2] + u[0]);
}

/// The point of the lumpy ball in a direction, and its outward normal by differences.
inline void push_lump(emtr::Surface& surface, const Vector& u, double spread) {
  const auto at = [](Vector v) {
    const double r = std::sqrt(dot(v, v));
    for (double& c : v) c /= r;
    const double radius = lump_radius(v);
    return Vector{radius * v[0], radius * v[1], radius * v[2]};
  };
  const Vector a = std::abs(u[0]) < 0.7 ? Vector{1, 0, 0} : Vector{0, 1, 0};
  const auto cross = [](const Vector& p, const Vector& q) {
    return Vector{p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
  };
  const Vector b = cross(u, a), c = cross(u, b), p = at(u);
  Vector along[2];
  for (int k = 0; k < 2; ++k) {
    const Vector& d = k == 0 ? b : c;
    const Vector q = at({u[0] + 1e-4 * d[0], u[1] + 1e-4 * d[1], u[2] + 1e-4 * d[2]});
    along[k] = {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
  }
  Vector n = cross(along[0], along[1]);
  const double length = std::sqrt(dot(n, n)) * (dot(n, u) < 0 ? -1 : 1);
  for (double& v : n) v /= length;
  push(surface, {p[0] + spread * n[0], p[1] + spread * n[1], p[2] + spread * n[2]}, n);
}

/// n points all over the lumpy ball, or only where the direction has at least `least` along z.
inline emtr::Surface lumpy_ball(std::size_t n, unsigned seed, double leaf, double noise = 0,
                                double least = -1) {
  std::mt19937 random(seed);
  const auto draw = [&] { return static_cast<double>(random()) / 2147483648.0 - 1; };
  emtr::Surface out;
  out.leaf = leaf;
  while (out.points.size() < n) {
    Vector u{draw(), draw(), draw()};
    const double length = std::sqrt(dot(u, u));
    if (length > 1 || length < 0.1) continue;
    for (double& v : u) v /= length;
    if (u[2] >= least) push_lump(out, u, noise * draw());
  }
  return out;
}

}  // namespace emtr_test
