#include "refinement/similarity_refinement.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "refinement/hessian_spectrum.h"
#include "util/cancellation.h"

namespace emtr {
namespace {

using Eigen::Vector3d;

constexpr double kLargestStep = 0.1;  // of the logarithm of the scale, in one iteration

/// Adds one pair by its residual along the mean of both normals.
void add(const Similarity& at, const SurfacePoint& source, const SurfacePoint& target,
         double cut_off, double gate, SimilarityEquations& sums) {
  const Vector3d p(source.p[0], source.p[1], source.p[2]), q(target.p[0], target.p[1], target.p[2]),
      n(target.n[0], target.n[1], target.n[2]);
  const Vector3d y = at * p, d = y - q, m = at.rotate({source.n[0], source.n[1], source.n[2]});
  const double cosine = m[0] * n[0] + m[1] * n[1] + m[2] * n[2];
  if (!(std::abs(cosine) > gate)) return;  // not for a NaN either
  const double sign = cosine < 0 ? -1 : 1, length = std::sqrt(2 + 2 * std::abs(cosine));
  const Vector3d u = (n + sign * m) / length;
  const double e = u[0] * d[0] + u[1] * d[1] + u[2] * d[2], share = e / cut_off;
  const double bend = 1 - share * share;
  if (!(bend > 0)) return;
  const double w = bend * bend;
  const Vector3d lever = y.cross(u), from_source = y - at.pose.t;
  const double J[7] = {lever[0],
                       lever[1],
                       lever[2],
                       u[0],
                       u[1],
                       u[2],
                       u[0] * from_source[0] + u[1] * from_source[1] + u[2] * from_source[2]};
  for (int i = 0; i < 7; ++i) {
    for (int j = i; j < 7; ++j) sums.H(i, j) += w * J[i] * J[j];
    sums.g[i] += w * e * J[i];
  }
  sums.moments += w * y;
  sums.second_moment += w * (y[0] * y[0] + y[1] * y[1] + y[2] * y[2]);
  sums.weights += w;
  sums.squared_influence += w * w * e * e;
  sums.slopes += bend * (bend - 4 * share * share);
  ++sums.inliers;
}

/// The equations per weight for changes about the matches' centroid, with lengths in their root
/// mean square radius.
struct Centered {
  Matrix7 axes;  ///< J about the centroid = axes J
  Matrix7 H;
  Vector7 g;
  bool spread = false;  ///< the matches are not all on one point
};

Centered centered(const SimilarityEquations& sums, const Vector3d& source_origin) {
  Centered out;
  const Vector3d c = sums.moments / sums.weights;
  const double radius = std::sqrt(
      std::max(0.0, sums.second_moment / sums.weights - (c[0] * c[0] + c[1] * c[1] + c[2] * c[2])));
  out.spread = radius > 0;
  if (!out.spread) return out;
  const Vector3d o = source_origin - c;
  out.axes = Matrix7::Identity();
  // (y - c) x n = y x n - c x n, and n.(y - c) = n.(y - o) + n.(o - c).
  out.axes.block<3, 3>(0, 3) << 0, c.z(), -c.y(), -c.z(), 0, c.x(), c.y(), -c.x(), 0;
  out.axes.block<1, 3>(6, 3) = o.transpose();
  out.axes.topRows<3>() /= radius;
  out.axes.row(6) /= radius;
  const Matrix7 H = sums.H.selfadjointView<Eigen::Upper>();
  out.H = out.axes * H * out.axes.transpose() / sums.weights;
  out.g = out.axes * sums.g / sums.weights;
  return out;
}

/// Returns the step along the directions that are constrained.
Vector7 solve(const Centered& at) {
  const Eigen::SelfAdjointEigenSolver<Matrix7> solver(at.H);
  Vector7 step = Vector7::Zero();
  for (int k = 0; k < 7; ++k) {
    const double value = solver.eigenvalues()[k];
    if (value < kUnconstrainedEigenvalue) continue;
    const Vector7 v = solver.eigenvectors().col(k);
    step -= v * (v.dot(at.g) / value);
  }
  return step;
}

double scale_constraint(const Centered& at) {
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  const Eigen::SelfAdjointEigenSolver<Matrix6> solver(at.H.topLeftCorner<6, 6>());
  const Eigen::Matrix<double, 6, 1> both = at.H.topRightCorner<6, 1>();
  double out = at.H(6, 6);
  for (int k = 0; k < 6; ++k) {
    if (solver.eigenvalues()[k] < kUnconstrainedEigenvalue) continue;
    const double along = solver.eigenvectors().col(k).dot(both);
    out -= along * along / solver.eigenvalues()[k];
  }
  return std::max(0.0, out);
}

}  // namespace

SimilarityRefinement::SimilarityRefinement(const SharedSurface& source, const SharedSurface& target,
                                           const Neighbors& near_source,
                                           const Neighbors& near_target,
                                           const LocalRefinementSettings& settings,
                                           const Kernels& kernels)
    : settings_(validated(settings)),
      leaf_(target->leaf),
      matcher_({source, settings.queries, settings.first_queries},
               {target, settings.queries, settings.first_queries}, &near_source, &near_target,
               kernels) {}

SimilarityEquations SimilarityRefinement::sum_up(const Similarity& at, double cut_off,
                                                 bool all_queries,
                                                 SurfaceMatcher::Scratch& scratch) const {
  SimilarityEquations sums;
  const double reach = std::max(cut_off, settings_.reach * leaf_);
  for (const bool reversed : {false, true}) {
    const QueryPoints& queries = reversed ? matcher_.target() : matcher_.source();
    const std::size_t count = all_queries ? queries.size() : queries.first();
    matcher_.for_each_match(at, reversed ? reach / at.scale : reach, {reversed, 0, count, 0},
                            scratch, [&](const SurfacePoint& source, const SurfacePoint& target) {
                              add(at, source, target, cut_off, settings_.normal_gate, sums);
                            });
  }
  return sums;
}

SimilarityFit SimilarityRefinement::operator()(const Similarity& start, const Prior* prior) const {
  SurfaceMatcher::Scratch scratch;
  scratch.grow(std::max(matcher_.source().size(), matcher_.target().size()));
  SimilarityFit out;
  out.similarity = start;
  Similarity at = start;
  const double last = settings_.last_scale * leaf_;
  double cut_off = std::max(last, settings_.first_scale * leaf_);
  for (int i = 0; i < settings_.iterations; ++i) {
    check_cancelled();
    const bool all_queries = cut_off <= last;
    const SimilarityEquations sums = sum_up(at, cut_off, all_queries, scratch);
    if (sums.inliers < settings_.minimum_inliers) return out;
    const Centered equations = centered(sums, at.pose.t);
    if (!equations.spread) return out;
    const Vector7 step = solve(equations);
    if (!step.allFinite()) return out;
    out.sums = sums;
    out.scale_constraint = scale_constraint(equations);
    Vector7 x = equations.axes.transpose() * step;
    x[6] = std::clamp(x[6], -kLargestStep, kLargestStep);
    at = moved(at, x.data());
    if (prior) at.pose = prior->project(at.pose);
    if (all_queries && step.norm() < settings_.step * leaf_) break;
    cut_off = std::max(last, cut_off * settings_.shrink);
  }
  out.similarity = at;
  out.succeeded = true;
  return out;
}

}  // namespace emtr
