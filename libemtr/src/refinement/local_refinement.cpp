#include "refinement/local_refinement.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <functional>

#include "geometry/small_motion.h"
#include "refinement/constrained_step.h"
#include "refinement/matched_pairs.h"
#include "refinement/plane_to_plane.h"
#include "util/error.h"

namespace emtr {
namespace {

constexpr std::size_t kBlock = 512;  // queries whose sums are one piece of work
/// Damps as Levenberg and Marquardt do, by the sum of weights: far below what a surface of any
/// shape constrains, and enough for a step along unconstrained directions to stay small.
constexpr double kDamping = 1e-6;

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
      kernels_(kernels),
      matcher_({source, settings.queries, settings.first_queries},
               {target, settings.queries, settings.first_queries}, near_source, near_target,
               kernels) {
  require(near_target, "near_target: expected the neighbors of the target");
  require(near_source || !settings.both_ways, "near_source: expected the neighbors of the source");
}

/// Sums up the normal equations over all matches, block by block in a fixed order.
void LocalRefinement::accumulate(const State& at, Scratch& s, ThreadTeam& team,
                                 LocalRefinementResult& out) const {
  const auto count = [&](const QueryPoints& q) { return at.all_queries ? q.size() : q.first(); };
  const std::size_t n = count(matcher_.source()),
                    m = settings_.both_ways ? count(matcher_.target()) : 0;
  const std::size_t blocks = (n + kBlock - 1) / kBlock, total = blocks + (m + kBlock - 1) / kBlock;
  s.blocks.assign(total, NormalEquations());
  const PlaneToPlane estimator(at.pose, at.scale, settings_.softness, settings_.normal_gate);
  team.parallel(total, [&](std::size_t b, std::size_t) {
    const bool reversed = b >= blocks;
    const std::size_t begin = (reversed ? b - blocks : b) * kBlock,
                      end = std::min(begin + kBlock, reversed ? m : n);
    MatchedPairs<kBlock> pairs;
    matcher_.for_each_match(
        at.pose, reach(at), {reversed, begin, end, b * kBlock}, s.matches,
        [&](const SurfacePoint& source, const SurfacePoint& target) { pairs.add(source, target); });
    s.blocks[b] = estimator.sums(pairs.view(), kernels_);
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
  return finish(start, approach(start, prior, s, threads), prior, s, threads);
}

LocalRefinementResult LocalRefinement::approach(const Rigid& start, const Prior* prior, Scratch& s,
                                                int threads) const {
  double T[16];
  to_matrix(start, T);
  require(is_rigid(T), "start: expected a finite rigid pose");
  LocalRefinementResult out;
  out.pose = start;
  out.end = Termination::IterationLimit;
  out.both_ways = settings_.both_ways;
  return run(Part::First, start, prior, s, threads, out);
}

LocalRefinementResult LocalRefinement::finish(const Rigid& start,
                                              const LocalRefinementResult& approached,
                                              const Prior* prior, Scratch& s, int threads) const {
  return run(Part::Second, start, prior, s, threads, approached);
}

LocalRefinementResult LocalRefinement::run(Part part, const Rigid& start, const Prior* prior,
                                           Scratch& s, int threads,
                                           LocalRefinementResult out) const {
  const auto body = [&](ThreadTeam& team) { iterate(part, start, prior, s, team, out); };
  ThreadTeam::with(threads, std::ref(body));
  return out;
}

void LocalRefinement::iterate(Part part, const Rigid& start, const Prior* prior, Scratch& s,
                              ThreadTeam& team, LocalRefinementResult& out) const {
  const std::size_t source_blocks = matcher_.source().size() / kBlock + 1,
                    target_blocks = matcher_.target().size() / kBlock + 1;
  s.matches.grow((source_blocks + target_blocks) * kBlock);

  const double last = settings_.last_scale * leaf_;
  const bool second = part == Part::Second;
  State at{out.pose, second ? last : settings_.first_scale * leaf_, second};
  while ((second || at.scale > last) && out.iterations < settings_.iterations &&
         out.end == Termination::IterationLimit) {
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
    if (second && step.norm() < settings_.step * leaf_) out.end = Termination::Converged;
    at.scale = std::max(last, at.scale * settings_.shrink);
  }
  out.pose = at.pose;
}

}  // namespace emtr
