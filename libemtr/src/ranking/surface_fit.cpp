#include "ranking/surface_fit.h"

#include <cmath>
#include <stdexcept>

#include "geometry/transform.h"

namespace emtr {
namespace {

constexpr float kReach = 1.5f;      // leaves, to the nearest neighbor
constexpr float kTolerance = 0.3f;  // leaves, off the tangent plane
constexpr float kSameWay = 0.7f;    // of the dot product of both normals
// Leaves, of the candidate grid: with half of it a pose would cost a tenth less, and the grids
// five times as much, a hundred poses or more.
constexpr float kCell = 1.5f;

Cloud every(const Cloud& cloud, std::size_t step) {
  Cloud out;
  out.resize((cloud.size() + step - 1) / step);
  for (std::size_t i = 0; i < out.size(); ++i) {
    out.x[i] = cloud.x[i * step];
    out.y[i] = cloud.y[i * step];
    out.z[i] = cloud.z[i * step];
  }
  return out;
}

}  // namespace

SurfaceFit::Side SurfaceFit::make_side(const Surface& surface, const Kernels& kernels) {
  const Cloud &p = surface.points, &n = surface.normals;
  if (p.size() == 0 || n.size() != p.size())
    throw std::invalid_argument("surface: expected points, and a normal for each");
  Side side{&surface, {}, {}};
  side.places.resize(p.size());
  for (std::size_t i = 0; i < p.size(); ++i)
    side.places[i] = {{p.x[i], p.y[i], p.z[i]}, {n.x[i], n.y[i], n.z[i]}};
  const auto leaf = static_cast<float>(surface.leaf);
  side.neighbors = make_candidate_grid(p, kReach * leaf, kCell * leaf, kernels);
  return side;
}

SurfaceFit::SurfaceFit(const Surface& source, const Surface& target, const Kernels& kernels)
    : kernels_(kernels), leaf_(static_cast<float>(source.leaf)) {
  if (!(source.leaf > 0) || source.leaf != target.leaf)
    throw std::invalid_argument("surfaces: expected one positive leaf for both");
  side_[0] = make_side(source, kernels);
  side_[1] = make_side(target, kernels);
}

void SurfaceFit::prepare(std::size_t step) {
  if (step == 0) throw std::invalid_argument("step: expected at least 1");
  for (const Subset& subset : subsets_)
    if (subset.step == step) return;
  Subset subset{step, {}, {}};
  for (int s = 0; s < 2; ++s) {
    subset.points[s] = every(side_[s].surface->points, step);
    subset.normals[s] = every(side_[s].surface->normals, step);
  }
  subsets_.push_back(std::move(subset));
}

SurfaceFit::Sums SurfaceFit::sums(const Cloud& points, const Cloud& normals, const Rigid& pose, const Side& to,
                    Scratch& s) const {
  const std::size_t n = points.size();
  if (s.x.size() < n) {
    for (auto* v : {&s.x, &s.y, &s.z, &s.nx, &s.ny, &s.nz, &s.squared}) v->resize(n);
    s.index.resize(n);
  }
  const Rigid rotation = {pose.R, Eigen::Vector3d::Zero()};
  transform(kernels_, points, pose, s.x.data(), s.y.data(), s.z.data());
  transform(kernels_, normals, rotation, s.nx.data(), s.ny.data(), s.nz.data());
  to.neighbors->nearest({s.x.data(), s.y.data(), s.z.data(), n}, s.index.data(), s.squared.data());

  const float unit = 1.0f / leaf_;
  Sums sum;
  for (std::size_t i = 0; i < n; ++i) {
    if (s.index[i] < 0) continue;
    const Place& q = to.places[static_cast<std::size_t>(s.index[i])];
    const float e =
        ((q.n[0] * (s.x[i] - q.p[0]) + q.n[1] * (s.y[i] - q.p[1])) + q.n[2] * (s.z[i] - q.p[2])) *
        unit;
    const float dot = (s.nx[i] * q.n[0] + s.ny[i] * q.n[1]) + s.nz[i] * q.n[2];
    // Without a normal both are NaN, and no inlier. No branches: which way they go is a toss-up.
    const bool same_way = std::abs(dot) > kSameWay, near = std::abs(e) < kTolerance;
    const bool inlier = same_way & near;
    const float off = e * (1.0f / kTolerance), w = 1.0f - off * off;
    const float weight = inlier ? w * w : 0.0f;
    sum.weight += static_cast<double>(weight);
    sum.same += static_cast<double>(dot > 0 ? weight : 0.0f);
    sum.sign += static_cast<double>(inlier ? dot : 0.0f);
    sum.squared += static_cast<double>(inlier ? e * e : 0.0f);
    sum.inliers += static_cast<double>(inlier ? 1.0f : 0.0f);
  }
  return sum;
}

SurfaceFitValue SurfaceFit::value(const Cloud* const points[2], const Cloud* const normals[2], const Rigid& pose,
                    Scratch& scratch) const {
  const Sums a = sums(*points[0], *normals[0], pose, side_[1], scratch);
  const Sums b = sums(*points[1], *normals[1], pose.inverse(), side_[0], scratch);
  const auto n = static_cast<double>(points[0]->size()), m = static_cast<double>(points[1]->size());
  SurfaceFitValue out;
  out.score = (a.weight / n + b.weight / m) / 2;
  out.same_side = (a.same / n + b.same / m) / 2;
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
  const Cloud* const points[2] = {&side_[0].surface->points, &side_[1].surface->points};
  const Cloud* const normals[2] = {&side_[0].surface->normals, &side_[1].surface->normals};
  return value(points, normals, pose, scratch);
}

SurfaceFitValue SurfaceFit::evaluate(const Rigid& pose, std::size_t step, Scratch& scratch) const {
  if (step == 1) return evaluate(pose, scratch);
  const Subset& some = subset(step);
  const Cloud* const points[2] = {&some.points[0], &some.points[1]};
  const Cloud* const normals[2] = {&some.normals[0], &some.normals[1]};
  return value(points, normals, pose, scratch);
}

const Cloud& SurfaceFit::points(int side, std::size_t step) const {
  return step == 1 ? side_[side].surface->points : subset(step).points[side];
}

const SurfaceFit::Subset& SurfaceFit::subset(std::size_t step) const {
  for (const Subset& some : subsets_)
    if (some.step == step) return some;
  throw std::invalid_argument("step: expected one that was prepared");
}

}  // namespace emtr
