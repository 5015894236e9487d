#include "ranking/surface_fit.h"

#include <cmath>
#include <stdexcept>

#include "geometry/transform.h"

namespace emtr {
namespace {

constexpr float kReach = 1.5f;          // leaves, to the nearest neighbor
constexpr float kTolerance = 0.3f;      // leaves, off the tangent plane
constexpr float kMinimumCosine = 0.7f;  // between the normals
// Leaves, of the candidate grid: with half of it a pose would cost a tenth less, and the grids
// five times as much, a hundred poses or more.
constexpr float kCell = 1.5f;

float common_leaf(const Surface& source, const Surface& target) {
  if (!(source.leaf > 0) || source.leaf != target.leaf)
    throw std::invalid_argument("surfaces: expected one positive leaf for both");
  return static_cast<float>(source.leaf);
}

}  // namespace

SurfaceFit::Side SurfaceFit::make_side(const SharedSurface& surface, const Kernels& kernels) {
  const Cloud& points = surface->points;
  if (points.size() == 0 || surface->normals.size() != points.size())
    throw std::invalid_argument("surface: expected points, and a normal for each");
  const auto leaf = static_cast<float>(surface->leaf);
  return {surface, make_candidate_grid(points, kReach * leaf, kCell * leaf, kernels)};
}

SurfaceFit::SurfaceFit(const SharedSurface& source, const SharedSurface& target,
                       const Kernels& kernels)
    : kernels_(kernels),
      leaf_(common_leaf(*source, *target)),
      side_{make_side(source, kernels), make_side(target, kernels)} {}

void SurfaceFit::add_subset(std::size_t step) {
  if (step == 0) throw std::invalid_argument("step: expected at least 1");
  for (const Subset& subset : subsets_)
    if (subset.step == step) return;
  subsets_.push_back(
      {step, {every_nth(*side_[0].surface, step), every_nth(*side_[1].surface, step)}});
}

SurfaceFit::Sums SurfaceFit::sums(const Surface& from, const Rigid& pose, const Side& to,
                                  Scratch& s) const {
  const std::size_t n = from.points.size();
  if (s.x.size() < n) {
    for (auto* v : {&s.x, &s.y, &s.z, &s.nx, &s.ny, &s.nz, &s.squared}) v->resize(n);
    s.index.resize(n);
  }
  const Rigid rotation = {pose.R, Eigen::Vector3d::Zero()};
  transform(kernels_, from.points, pose, s.x.data(), s.y.data(), s.z.data());
  transform(kernels_, from.normals, rotation, s.nx.data(), s.ny.data(), s.nz.data());
  to.neighbors->nearest({s.x.data(), s.y.data(), s.z.data(), n}, s.index.data(), s.squared.data());

  const SurfacePoint* const neighbors = to.surface.interleaved().data();
  const float unit = 1.0f / leaf_;
  Sums sum;
  for (std::size_t i = 0; i < n; ++i) {
    if (s.index[i] < 0) continue;
    const SurfacePoint& q = neighbors[s.index[i]];
    const float e =
        ((q.n[0] * (s.x[i] - q.p[0]) + q.n[1] * (s.y[i] - q.p[1])) + q.n[2] * (s.z[i] - q.p[2])) *
        unit;
    const float dot = (s.nx[i] * q.n[0] + s.ny[i] * q.n[1]) + s.nz[i] * q.n[2];
    // Without a normal both are NaN, and no inlier. No branches: which way they go is a toss-up.
    const bool aligned = std::abs(dot) > kMinimumCosine, near = std::abs(e) < kTolerance;
    const bool inlier = aligned & near;
    const float off = e * (1.0f / kTolerance), w = 1.0f - off * off;
    const float weight = inlier ? w * w : 0.0f;
    sum.weight += static_cast<double>(weight);
    sum.same_side += static_cast<double>(dot > 0 ? weight : 0.0f);
    sum.sign += static_cast<double>(inlier ? dot : 0.0f);
    sum.squared += static_cast<double>(inlier ? e * e : 0.0f);
    sum.inliers += static_cast<double>(inlier ? 1.0f : 0.0f);
  }
  return sum;
}

SurfaceFitValue SurfaceFit::value(const Surface& source, const Surface& target, const Rigid& pose,
                                  Scratch& scratch) const {
  const Sums a = sums(source, pose, side_[1], scratch);
  const Sums b = sums(target, pose.inverse(), side_[0], scratch);
  const auto n = static_cast<double>(source.points.size()),
             m = static_cast<double>(target.points.size());
  SurfaceFitValue out;
  out.score = (a.weight / n + b.weight / m) / 2;
  out.same_side = (a.same_side / n + b.same_side / m) / 2;
  out.inliers_source = a.inliers / n;
  out.inliers_target = b.inliers / m;
  const double inliers = a.inliers + b.inliers;
  if (inliers > 0) {
    out.sign = (a.sign + b.sign) / inliers;
    out.rms = std::sqrt((a.squared + b.squared) / inliers);
  }
  return out;
}

SurfaceFitValue SurfaceFit::evaluate(const Rigid& pose, Scratch& scratch) const {
  return value(*side_[0].surface, *side_[1].surface, pose, scratch);
}

SurfaceFitValue SurfaceFit::evaluate(const Rigid& pose, std::size_t step, Scratch& scratch) const {
  if (step == 1) return evaluate(pose, scratch);
  const Subset& some = subset(step);
  return value(some.side[0], some.side[1], pose, scratch);
}

const Cloud& SurfaceFit::points(int side, std::size_t step) const {
  return step == 1 ? side_[side].surface->points : subset(step).side[side].points;
}

const SurfaceFit::Subset& SurfaceFit::subset(std::size_t step) const {
  for (const Subset& some : subsets_)
    if (some.step == step) return some;
  throw std::invalid_argument("step: expected one that add_subset() was called for");
}

}  // namespace emtr
