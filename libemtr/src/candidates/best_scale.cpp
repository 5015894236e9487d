#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <vector>

#include "candidates/changed_source.h"
#include "geometry/similarity.h"
#include "geometry/small_motion.h"
#include "preprocessing/normalization.h"

namespace emtr {
namespace {

using Eigen::Vector3d;
using Vector7 = Eigen::Matrix<double, 7, 1>;
using Matrix7 = Eigen::Matrix<double, 7, 7>;

constexpr double kLeast = 0.75, kMost = 1.33;  // of the factor
constexpr double kNegligible = 0.05;           // of its logarithm
constexpr int kIterations = 15;
constexpr std::size_t kPoints = 1500;                                // that look for a match
constexpr double kFirstCutOff = 4, kLastCutOff = 1, kShrink = 0.85;  // leaves
constexpr double kConverged = 0.02;                                  // leaves, of a step
constexpr double kDamping = 1e-4;  // of the sum of weights: a plane has no scale to be found

Vector3d row(const Cloud& cloud, std::size_t i) {
  return {double{cloud.x[i]}, double{cloud.y[i]}, double{cloud.z[i]}};
}

/// Returns the surface with its lengths times a factor; its points then lie that much farther
/// apart, but the leaf stays, as both surfaces need the same.
Surface scaled(const Surface& surface, double factor) {
  Surface out = surface;
  out.points = scale_cloud(surface.points, factor);
  return out;
}

/// Makes one step: the matches of the source's points, Tukey's weights, and the normal equations of
/// a small rotation, a translation, and the logarithm of the factor. Returns how far it went.
double step(const Cloud& source, const SurfacePair& surfaces, double cut_off,
            const Kernels& kernels, Similarity& at) {
  const Cloud moved = scale_cloud(source, at.scale);
  const std::size_t n = moved.size();
  Cloud y;
  y.resize(n);
  transform(kernels, moved, at.pose, y.x.data(), y.y.data(), y.z.data());
  std::vector<std::int32_t> index(n);
  std::vector<float> squared(n);
  surfaces.near_target().nearest(y.view(), index.data(), squared.data());

  Matrix7 H = Matrix7::Zero();
  Vector7 g = Vector7::Zero();
  double weights = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (index[i] < 0) continue;
    const auto k = static_cast<std::size_t>(index[i]);
    const Vector3d p = row(y, i), normal = row(surfaces.target().normals, k);
    const double e = normal.dot(p - row(surfaces.target().points, k));
    const double share = e / cut_off;
    if (!(std::abs(share) < 1)) continue;  // or there is no normal
    const double w = (1 - share * share) * (1 - share * share);
    Vector7 J;
    J << p.cross(normal), normal, normal.dot(p - at.pose.t);
    for (int a = 0; a < 7; ++a)
      for (int b = 0; b <= a; ++b) H(a, b) += w * J[a] * J[b];
    g += w * e * J;
    weights += w;
  }
  H.diagonal().array() += kDamping * weights + 1e-12;
  const Vector7 x = -H.ldlt().solve(g);
  if (!x.allFinite()) return 0;
  // A change of scale about the source's centroid, which the pose maps to its translation.
  at.scale = std::clamp(at.scale * std::exp(std::clamp(x[6], -0.1, 0.1)), kLeast, kMost);
  at.pose = emtr::moved(at.pose, x.data());
  return x.norm();
}

}  // namespace

Rescaled best_scale(const SurfacePair& surfaces, const Rigid& pose, const Kernels& kernels) {
  Similarity at{1, pose};
  double cut_off = kFirstCutOff;
  const Surface& source = surfaces.source();
  const Cloud some = every_nth(source, 1 + source.points.size() / kPoints).points;
  for (int i = 0; i < kIterations; ++i) {
    const double leaf = surfaces.target().leaf;
    const double moved = step(some, surfaces, cut_off * leaf, kernels, at);
    if (cut_off == kLastCutOff && moved < kConverged * leaf) break;
    cut_off = std::max(kLastCutOff, kShrink * cut_off);
  }
  Rescaled out;
  if (std::abs(std::log(at.scale)) < kNegligible) return out;
  out.factor = std::round(at.scale * 1e6) / 1e6;  // digits that every C library agrees on

  std::optional<Viewpoint> viewpoint = surfaces.source_viewpoint();
  if (viewpoint)
    for (double& c : viewpoint->at) c *= out.factor;
  const SurfacePair rescaled(scaled(surfaces.source(), out.factor), surfaces.shared_target(),
                             viewpoint, surfaces.target_viewpoint(), kernels);
  Ranking::Scratch scratch;
  LocalRefinement::Scratch refinement;
  const Rigid end = rescaled.local_refinement()(at.pose, nullptr, refinement).pose;
  out.score = rescaled.ranking().evaluate(end, scratch).score;
  return out;
}

}  // namespace emtr
