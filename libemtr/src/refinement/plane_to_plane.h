#pragma once

#include <cmath>

#include "geometry/rigid.h"
#include "geometry/surface.h"
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

  void add(const SurfacePoint& source, const SurfacePoint& target, NormalEquations& sums) const {
    const Eigen::Vector3d p = Eigen::Vector3d(source.p[0], source.p[1], source.p[2]),
                          q = Eigen::Vector3d(target.p[0], target.p[1], target.p[2]),
                          n = Eigen::Vector3d(target.n[0], target.n[1], target.n[2]);
    const Eigen::Vector3d y = pose_ * p, d = y - q;
    const Eigen::Vector3d m = pose_.rotate({source.n[0], source.n[1], source.n[2]});
    const double cosine = m[0] * n[0] + m[1] * n[1] + m[2] * n[2];
    const double c = std::abs(cosine);
    if (!(c > gate_)) return;  // not for a NaN either
    // u = v / |v|, which enters in squares only: no root is taken.
    const double sign = cosine < 0 ? -1 : 1, squared_length = 2 + 2 * c,
                 variance = 2 * eps_ + (1 - eps_) * (1 - c);
    const double inverse = 1 / (squared_length * variance);
    const double along = 2 * eps_ * squared_length * inverse - eps_;
    const double v[3] = {n[0] + sign * m[0], n[1] + sign * m[1], n[2] + sign * m[2]};
    const double e = v[0] * d[0] + v[1] * d[1] + v[2] * d[2];
    const double squared = e * e * variance * inverse;  // (u.d)^2
    const double cost = along * squared + eps_ * (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    const double bend = 1 - cost * inverse_;
    if (!(bend > 0)) return;
    const double tukey = bend * bend, w = tukey * along;
    const double J[6] = {y[1] * v[2] - y[2] * v[1],
                         y[2] * v[0] - y[0] * v[2],
                         y[0] * v[1] - y[1] * v[0],
                         v[0],
                         v[1],
                         v[2]};
    sums.add_normal(J, e, w * variance * inverse);
    sums.add_difference(y.data(), d.data(), tukey * eps_);
    sums.weights += w;
    sums.squares += w * squared;
    sums.squared_influence += w * w * squared;
    sums.slopes += along * bend * (bend - 4 * along * squared * inverse_);
    sums.inliers += 1;
  }

 private:
  Rigid pose_;
  double inverse_, eps_, gate_;
};

}  // namespace emtr
