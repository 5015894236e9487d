#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "geometry/rigid.h"
#include "geometry/surface.h"
#include "kernels/search_kernels.h"
#include "refinement/normal_equations.h"

namespace emtr {

/// Generalized ICP's plane to plane (Segal, Haehnel, Thrun 2009) in closed form, with Tukey's
/// weights. Each point is known well along its normal (variance eps) and badly in its plane
/// (variance 1), so a pair's difference d has the covariance C = 2 - (1 - eps)(n n^T + m m^T).
/// Along the mean u of the two normals its variance is 2 eps + (1 - eps)(1 - n.m), across u it is
/// 2 within 15 percent for all that the gate lets through; scaled by 2 eps, d^T C^-1 d becomes
///   (a - eps) (u.d)^2 + eps |d|^2,   a = 2 eps / (2 eps + (1 - eps)(1 - n.m)):
/// residuals to the mean plane, those of pairs whose normals differ counting less, and a weak pull
/// in all directions that steadies those that the surface leaves unconstrained.
class PlaneToPlane {
 public:
  /// `scale`: Tukey's cut-off of the residuals; `gate`: the minimum |n.m|.
  PlaneToPlane(const Rigid& pose, double scale, double eps, double gate)
      : pose_(pose), inverse_(1 / (scale * scale)), eps_(eps), gate_(gate) {}

  /// Returns the sums over many pairs: those of add() but for rounding.
  NormalEquations sums(const PairsView& pairs, const Kernels& kernels) const {
    PlaneToPlaneView at{};
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) at.R[3 * a + b] = pose_.R(a, b);
      at.t[a] = pose_.t[a];
    }
    at.inverse_squared_scale = inverse_;
    at.softness = eps_;
    at.gate = gate_;
    double sums[kPairSums];
    search_kernels(kernels).plane_to_plane(pairs, at, sums);
    return NormalEquations::of(sums);
  }

  /// Adds one pair.
  void add(const SurfacePoint& source, const SurfacePoint& target, NormalEquations& sums) const {
    Terms t;
    if (!evaluate(source, target, t)) return;
    sums.add_normal(t.J, t.e, t.weight_of_normal());
    sums.add_difference(t.y.data(), t.d.data(), t.tukey * eps_);
    const double w = t.tukey * t.along;
    sums.weights += w;
    sums.squares += w * t.squared;
    sums.squared_influence += w * w * t.squared;
    sums.slopes += t.along * t.bend * (t.bend - 4 * t.along * t.squared * inverse_);
    sums.inliers += 1;
  }

  /// Writes what one pair adds to g; returns whether it adds anything.
  bool gradient(const SurfacePoint& source, const SurfacePoint& target, double g[6]) const {
    Terms t;
    if (!evaluate(source, target, t)) return false;
    const double w = t.weight_of_normal() * t.e;
    const Eigen::Vector3d wd = (t.tukey * eps_) * t.d, lever = t.y.cross(wd);
    for (int a = 0; a < 3; ++a) {
      g[a] = w * t.J[a] + lever[a];
      g[3 + a] = w * t.J[3 + a] + wd[a];
    }
    return true;
  }

 private:
  struct Terms {
    Eigen::Vector3d y, d;  // the moved point, and from its match to it
    double J[6], e;        // of the residual along v, not of unit length
    double squared;        // (u.d)^2
    double variance, inverse, along, bend, tukey;

    double weight_of_normal() const { return tukey * along * variance * inverse; }
  };

  /// Returns whether the pair has a weight above zero.
  bool evaluate(const SurfacePoint& source, const SurfacePoint& target, Terms& out) const {
    const Eigen::Vector3d p = Eigen::Vector3d(source.p[0], source.p[1], source.p[2]),
                          q = Eigen::Vector3d(target.p[0], target.p[1], target.p[2]),
                          n = Eigen::Vector3d(target.n[0], target.n[1], target.n[2]);
    const Eigen::Vector3d y = pose_ * p, d = y - q;
    const Eigen::Vector3d m = pose_.rotate({source.n[0], source.n[1], source.n[2]});
    const double cosine = m[0] * n[0] + m[1] * n[1] + m[2] * n[2];
    const double c = std::abs(cosine);
    if (!(c > gate_)) return false;  // not for a NaN either
    // u = v / |v|, which enters in squares only: no root is taken.
    const double sign = cosine < 0 ? -1 : 1, squared_length = 2 + 2 * c,
                 variance = 2 * eps_ + (1 - eps_) * (1 - c);
    const double inverse = 1 / (squared_length * variance);
    const double along = 2 * eps_ * squared_length * inverse - eps_;
    const double v[3] = {n[0] + sign * m[0], n[1] + sign * m[1], n[2] + sign * m[2]};
    const double e = v[0] * d[0] + v[1] * d[1] + v[2] * d[2];
    const double squared = e * e * variance * inverse;
    const double cost = along * squared + eps_ * (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    const double bend = 1 - cost * inverse_;
    if (!(bend > 0)) return false;
    out = {y,
           d,
           {y[1] * v[2] - y[2] * v[1], y[2] * v[0] - y[0] * v[2], y[0] * v[1] - y[1] * v[0], v[0],
            v[1], v[2]},
           e,
           squared,
           variance,
           inverse,
           along,
           bend,
           bend * bend};
    return true;
  }

  Rigid pose_;
  double inverse_, eps_, gate_;
};

}  // namespace emtr
