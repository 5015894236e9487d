#include "ranking/surface_fit.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "geometry/transform.h"
#include "ranking/distinctiveness.h"

namespace emtr {
namespace {

constexpr float kReach = 1.5f;          // leaves, to the nearest neighbor
constexpr float kTolerance = 0.3f;      // leaves, off the tangent plane
constexpr float kMinimumCosine = 0.7f;  // between the normals
constexpr float kSame = 0.01f;          // leaves, to a point that is the same
// Leaves, of the candidate grid: with half of it a pose would cost a tenth less, and the grids
// five times as much, a hundred poses or more.
constexpr float kCell = 1.5f;

float common_leaf(const Surface& source, const Surface& target) {
  if (!(source.leaf > 0) || source.leaf != target.leaf)
    throw std::invalid_argument("surfaces: expected one positive leaf for both");
  return static_cast<float>(source.leaf);
}

// In the memory of a surface.
struct Weights {
  std::vector<float> of_points;
};

SharedNeighbors near(const SharedSurface& surface, const Kernels& kernels) {
  const Cloud& points = surface->points;
  if (points.size() == 0 || surface->normals.size() != points.size())
    throw std::invalid_argument("surface: expected points, and a normal for each");
  const auto leaf = static_cast<float>(surface->leaf);
  return *surface.memo().get<SharedNeighbors>({kReach, kCell}, [&] {
    return make_candidate_grid(points, kReach * leaf, kCell * leaf, kernels);
  });
}

std::vector<float> remembered_distinctiveness(const SharedSurface& surface) {
  return surface.memo()
      .get<Weights>({}, [&] { return Weights{distinctiveness(*surface)}; })
      ->of_points;
}

}  // namespace

SurfaceFit::SurfaceFit(const SharedSurface& source, const SharedSurface& target,
                       const Kernels& kernels)
    : kernels_(kernels),
      leaf_(common_leaf(*source, *target)),
      neighbors_{near(source, kernels), near(target, kernels)} {
  plainest_of_target_ = least_distinctive(remembered_distinctiveness(target));
  subsets_.push_back({1,
                      {weighted(source, remembered_distinctiveness(source)),
                       weighted(target, remembered_distinctiveness(target))}});
}

void SurfaceFit::make_ahead(const SharedSurface& surface, const Kernels& kernels) {
  near(surface, kernels);
  remembered_distinctiveness(surface);
}

SurfaceFit::Weighted SurfaceFit::weighted(const SharedSurface& surface,
                                          std::vector<float> weights) {
  double sum = 0;
  for (const float w : weights) sum += static_cast<double>(w);
  if (sum > 0)
    for (float& w : weights) w /= static_cast<float>(sum);
  return {surface, std::move(weights)};
}

void SurfaceFit::add_subset(std::size_t step) {
  if (step == 0) throw std::invalid_argument("step: expected at least 1");
  for (const Subset& subset : subsets_)
    if (subset.step == step) return;
  const auto some = [step](const Weighted& all) {
    std::vector<float> weights;
    for (std::size_t i = 0; i < all.weights.size(); i += step) weights.push_back(all.weights[i]);
    return weighted(every_nth(*all.surface, step), std::move(weights));
  };
  const Subset& all = subset(1);
  subsets_.push_back({step, {some(all.side[0]), some(all.side[1])}});
}

SurfaceFit::Sums SurfaceFit::sums(const Weighted& from, const Similarity& similarity, int to,
                                  Scratch& s) const {
  const Surface& surface = *from.surface;
  const std::size_t n = surface.points.size();
  if (s.x.size() < n) {
    for (auto* v : {&s.x, &s.y, &s.z, &s.nx, &s.ny, &s.nz, &s.squared}) v->resize(n);
    s.index.resize(n);
  }
  std::vector<std::uint8_t>& inliers = s.inlier[1 - to];
  inliers.assign(n, 0);
  const Rigid rotation = {similarity.pose.R, Eigen::Vector3d::Zero()};
  transform(kernels_, surface.points.view(), similarity, s.x.data(), s.y.data(), s.z.data());
  transform(kernels_, surface.normals, rotation, s.nx.data(), s.ny.data(), s.nz.data());
  neighbors_[to]->nearest({s.x.data(), s.y.data(), s.z.data(), n}, s.index.data(),
                          s.squared.data());

  const SurfacePoint* const neighbors = subset(1).side[to].surface.interleaved().data();
  const float unit = 1.0f / leaf_, same = (kSame * leaf_) * (kSame * leaf_);
  Sums sum;
  for (std::size_t i = 0; i < n; ++i) {
    if (s.index[i] < 0) continue;
    const SurfacePoint& q = neighbors[s.index[i]];
    const float e =
        ((q.n[0] * (s.x[i] - q.p[0]) + q.n[1] * (s.y[i] - q.p[1])) + q.n[2] * (s.z[i] - q.p[2])) *
        unit;
    const float dot = (s.nx[i] * q.n[0] + s.ny[i] * q.n[1]) + s.nz[i] * q.n[2];
    // Without a normal both are NaN, and no inlier. No branches: which way they go is a toss-up.
    const bool aligned = std::abs(dot) > kMinimumCosine, close = std::abs(e) < kTolerance;
    const bool inlier = aligned & close;
    const float off = e * (1.0f / kTolerance), w = 1.0f - off * off;
    const float weight = inlier ? from.weights[i] * (w * w) : 0.0f;
    inliers[i] = inlier;
    sum.weight += static_cast<double>(weight);
    sum.same_side += static_cast<double>(dot > 0 ? weight : 0.0f);
    sum.near += static_cast<double>(from.weights[i]);
    sum.same_points += static_cast<double>(s.squared[i] < same ? 1.0f : 0.0f);
    sum.sign += static_cast<double>(inlier ? dot : 0.0f);
    sum.squared += static_cast<double>(inlier ? e * e : 0.0f);
    sum.inliers += static_cast<double>(inlier ? 1.0f : 0.0f);
  }
  return sum;
}

SurfaceFitValue SurfaceFit::evaluate(const Rigid& pose, std::size_t step, Scratch& scratch) const {
  return evaluate(Similarity{1, pose}, step, scratch);
}

SurfaceFitValue SurfaceFit::evaluate(const Similarity& similarity, std::size_t step,
                                     Scratch& scratch) const {
  const auto& [source, target] = subset(step).side;
  const Sums a = sums(source, similarity, 1, scratch);
  const Sums b = sums(target, similarity.inverse(), 0, scratch);
  SurfaceFitValue out;
  out.score_source = a.weight;
  out.score_target = b.weight;
  out.score = (a.weight + b.weight) / 2;
  out.same_side = (a.same_side + b.same_side) / 2;
  out.near = (a.near + b.near) / 2;
  out.inliers_source = a.inliers / static_cast<double>(source.weights.size());
  out.inliers_target = b.inliers / static_cast<double>(target.weights.size());
  out.same_points = (a.same_points + b.same_points) /
                    static_cast<double>(source.weights.size() + target.weights.size());
  const double inliers = a.inliers + b.inliers;
  if (inliers > 0) {
    out.sign = (a.sign + b.sign) / inliers;
    out.rms = std::sqrt((a.squared + b.squared) / inliers);
  }
  return out;
}

const Cloud& SurfaceFit::points(int side, std::size_t step) const {
  return subset(step).side[side].surface->points;
}

const SurfaceFit::Subset& SurfaceFit::subset(std::size_t step) const {
  for (const Subset& some : subsets_)
    if (some.step == step) return some;
  throw std::invalid_argument("step: expected one that add_subset() was called for");
}

}  // namespace emtr
