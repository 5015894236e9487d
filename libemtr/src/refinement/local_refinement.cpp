#include "refinement/local_refinement.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "geometry/small_motion.h"
#include "geometry/transform.h"
#include "refinement/constrained_step.h"
#include "refinement/plane_to_plane.h"
#include "util/error.h"

namespace emtr {
namespace {

constexpr std::size_t kBlock = 512;  // queries whose sums are one piece of work
/// Damps as Levenberg and Marquardt do, by the sum of weights: far below what a surface of any
/// shape constrains, and enough for a step along unconstrained directions to stay small.
constexpr double kDamping = 1e-6;
/// Leaves: the cubes in which pairs are taken to say the same. Larger ones change little, until
/// there are too few of them.
constexpr double kCluster = 3;

void require(bool holds, const char* expected) {
  if (!holds) throw Error(EMTR_ERROR_ARGUMENT, expected);
}

/// Returns the Gauss-Newton step from a pose that keeps to the prior.
Vector6 solve(const NormalEquations& sums, const Rigid& pose, const Prior* prior) {
  Matrix6 H;
  sums.full_matrix(H.data());
  H.diagonal().array() += kDamping * sums.weights;
  if (prior) return constrained_step(H, Vector6::Map(sums.g), prior->limits(pose));
  return -H.ldlt().solve(Vector6::Map(sums.g));
}

}  // namespace

LocalRefinement::LocalRefinement(const SharedSurface& source, const SharedSurface& target,
                                 const Neighbors* near_source, const Neighbors* near_target,
                                 const LocalRefinementSettings& settings, const Kernels& kernels)
    : settings_(validated(settings)),
      leaf_(target->leaf),
      source_(source, settings.queries, settings.first_queries),
      target_(target, settings.queries, settings.first_queries),
      near_source_(near_source),
      near_target_(near_target),
      kernels_(kernels) {
  require(near_target, "near_target: expected the neighbors of the target");
  require(near_source || !settings.both_ways, "near_source: expected the neighbors of the source");
}

/// Calls visit(source, target) for the match of each of the queries begin to end, of the source or,
/// `reversed`, of the target; they work in the scratch from `offset` on.
template <class Visit>
void LocalRefinement::for_each_match(const State& at, bool reversed, std::size_t begin,
                                     std::size_t end, std::size_t offset, Scratch& s,
                                     const Visit& visit) const {
  const QueryPoints &asking = reversed ? target_ : source_,
                    &answering = reversed ? source_ : target_;
  const Neighbors& near = reversed ? *near_source_ : *near_target_;
  const std::size_t n = end - begin;
  float *x = &s.x[offset], *y = &s.y[offset], *z = &s.z[offset], *squared = &s.squared[offset];
  std::int32_t* index = &s.index[offset];
  const Rigid pose = reversed ? at.pose.inverse() : at.pose;
  transform(kernels_, asking.view(begin, end), pose, x, y, z);
  near.nearest({x, y, z, n}, index, squared);

  const double reach = std::max(at.scale, settings_.reach * leaf_);
  const auto limit = static_cast<float>(reach * reach);
  const SurfacePoint *queries = asking.surface(), *neighbors = answering.surface();
  const std::int32_t* rows = asking.rows() + begin;
  for (std::size_t i = 0; i < n; ++i) {
    if (index[i] < 0 || !(squared[i] < limit)) continue;
    const SurfacePoint &a = queries[rows[i]], &b = neighbors[index[i]];
    visit(reversed ? b : a, reversed ? a : b);
  }
}

/// Sums up the normal equations over all matches, block by block in a fixed order.
void LocalRefinement::accumulate(const State& at, Scratch& s, ThreadTeam& team,
                                 LocalRefinementResult& out) const {
  const auto count = [&](const QueryPoints& q) { return at.all_queries ? q.size() : q.first(); };
  const std::size_t n = count(source_), m = settings_.both_ways ? count(target_) : 0;
  const std::size_t blocks = (n + kBlock - 1) / kBlock, total = blocks + (m + kBlock - 1) / kBlock;
  s.blocks.assign(total, NormalEquations());
  const PlaneToPlane estimator(at.pose, at.scale, settings_.softness, settings_.normal_gate);
  team.parallel(total, [&](std::size_t b, std::size_t) {
    const bool reversed = b >= blocks;
    const std::size_t begin = (reversed ? b - blocks : b) * kBlock;
    for_each_match(at, reversed, begin, std::min(begin + kBlock, reversed ? m : n), b * kBlock, s,
                   [&](const SurfacePoint& source, const SurfacePoint& target) {
                     estimator.add(source, target, s.blocks[b]);
                   });
  });
  const auto share = [](double inliers, std::size_t queries) {
    return queries ? inliers / static_cast<double>(queries) : 0;
  };
  NormalEquations sums;
  for (std::size_t b = 0; b < blocks; ++b) sums.add(s.blocks[b]);
  out.inlier_share_source = share(sums.inliers, n);
  const double source_inliers = sums.inliers;
  for (std::size_t b = blocks; b < total; ++b) sums.add(s.blocks[b]);
  out.inlier_share_target = share(sums.inliers - source_inliers, m);
  out.sums = sums;
  out.rmse = sums.weights > 0 ? std::sqrt(sums.squares / sums.weights) : 0;
}

LocalRefinementResult LocalRefinement::operator()(const Rigid& start, const Prior* prior,
                                                  Scratch& s, int threads) const {
  LocalRefinementResult out;
  const auto body = [&](ThreadTeam& team) { out = run(start, prior, s, team); };
  ThreadTeam::with(threads, std::ref(body));
  return out;
}

void LocalRefinement::resize(Scratch& s) const {
  const std::size_t size = (source_.size() / kBlock + target_.size() / kBlock + 2) * kBlock;
  for (auto* v : {&s.x, &s.y, &s.z, &s.squared}) v->resize(std::max(v->size(), size));
  s.index.resize(std::max(s.index.size(), size));
}

LocalRefinementResult LocalRefinement::run(const Rigid& start, const Prior* prior, Scratch& s,
                                           ThreadTeam& team) const {
  double T[16];
  to_matrix(start, T);
  require(is_rigid(T), "start: expected a finite rigid pose");
  resize(s);

  LocalRefinementResult out;
  out.both_ways = settings_.both_ways;
  const double last = settings_.last_scale * leaf_;
  State at{start, settings_.first_scale * leaf_, settings_.first_scale <= settings_.last_scale};
  out.end = Termination::IterationLimit;
  while (out.iterations < settings_.iterations && out.end == Termination::IterationLimit) {
    accumulate(at, s, team, out);
    ++out.iterations;
    const Vector6 step = solve(out.sums, at.pose, prior);
    if (out.sums.inliers < static_cast<double>(settings_.minimum_inliers) || !step.allFinite()) {
      out = {};
      at.pose = start;
      break;
    }
    at.pose = moved(at.pose, step.data());
    if (prior) at.pose = prior->project(at.pose);
    if (at.all_queries && step.norm() < settings_.step * leaf_) out.end = Termination::Converged;
    at.scale = std::max(last, at.scale * settings_.shrink);
    at.all_queries = at.all_queries || at.scale <= last;
  }
  out.pose = at.pose;
  return out;
}

double LocalRefinement::design_effect(const LocalRefinementResult& refined, Scratch& s) const {
  using Gradient = std::array<double, 6>;
  const auto squared = [](const double* g) {
    double sum = 0;
    for (int k = 0; k < 6; ++k) sum += g[k] * g[k];
    return sum;
  };
  const State at{refined.pose, settings_.last_scale * leaf_, true};
  const PlaneToPlane estimator(at.pose, at.scale, settings_.softness, settings_.normal_gate);
  std::map<std::array<double, 3>, Gradient> clusters;
  double pairs_squared = 0, clusters_squared = 0;
  const auto visit = [&](const SurfacePoint& source, const SurfacePoint& target) {
    NormalEquations one;
    estimator.add(source, target, one);
    std::array<double, 3> cube{};
    for (std::size_t a = 0; a < 3; ++a)
      cube[a] = std::floor(static_cast<double>(target.p[a]) / (kCluster * leaf_));
    Gradient& sum = clusters[cube];
    for (std::size_t k = 0; k < 6; ++k) sum[k] += one.g[k];
    pairs_squared += squared(one.g);
  };
  for_each_match(at, false, 0, source_.size(), 0, s, visit);
  if (settings_.both_ways) for_each_match(at, true, 0, target_.size(), 0, s, visit);
  for (const auto& [cube, sum] : clusters) clusters_squared += squared(sum.data());
  return pairs_squared > 0 ? std::max(1.0, clusters_squared / pairs_squared) : 1;
}

}  // namespace emtr
