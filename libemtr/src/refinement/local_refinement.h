#pragma once

#include <algorithm>
#include <vector>

#include "geometry/rigid.h"
#include "kernels/kernels.h"
#include "neighbors/neighbors.h"
#include "priors/prior.h"
#include "refinement/local_refinement_settings.h"
#include "refinement/normal_equations.h"
#include "refinement/surface_matcher.h"
#include "util/thread_team.h"

namespace emtr {

enum class Termination {
  Converged,       ///< the last step was as small as asked
  IterationLimit,  ///< it was not when they ran out: the pose is of use, but may still drift
  TooFewInliers    ///< nothing could be done: the pose is the one at the start
};

struct LocalRefinementResult {
  Rigid pose;  ///< source into target: q = R p + t
  Termination end = Termination::TooFewInliers;
  int iterations = 0;
  double rmse = 0;                 ///< weighted, of the residuals to the mean planes, in the
                                   ///< normalized frame; 0 when nothing could be done
  double inlier_share_source = 0;  ///< queries of the source with a match of weight above zero
  double inlier_share_target = 0;  ///< and of the target; 0 unless both_ways
  bool both_ways = true;           ///< so pairs may be counted twice
  NormalEquations sums;            ///< at the last iteration: for information(), hessian_spectrum()
};

/// Refines poses of one pair of surfaces; built once, then called for each start. Gauss-Newton on
/// SE(3) with matches searched anew in each iteration, all sums in double and in an order that does
/// not depend on the threads. The neighbors and the kernels must outlive it.
class LocalRefinement {
 public:
  /// Working memory of one call at a time; keep one a thread, so that only the first call
  /// allocates.
  struct Scratch {
    SurfaceMatcher::Scratch matches;
    std::vector<NormalEquations> blocks;
  };

  /// Neighbors of the points of the two surfaces, with a radius of first_scale leaves (and of
  /// `reach` leaves when that is more); `near_source` may be null unless both_ways. Throws Error
  /// when a setting is out of its range, a surface is not whole, or its neighbors are missing.
  LocalRefinement(const SharedSurface& source, const SharedSurface& target,
                  const Neighbors* near_source, const Neighbors* near_target,
                  const LocalRefinementSettings& settings, const Kernels& kernels);

  /// Refines a pose. Safe to call from several threads at once, each with its own scratch.
  /// `threads` share the work of this one call, which gives the same bits for any number. With a
  /// prior, one that admits the start, each step is the best one within it, and the end an optimum
  /// among its poses. Throws Error when the start is not a finite rigid pose.
  LocalRefinementResult operator()(const Rigid& start, const Prior* prior, Scratch& scratch,
                                   int threads = 1) const;

  /// The same in two parts: approach() does the iterations whose cut-off still shrinks, those that
  /// look at first_queries points, and finish() the others, from the start that was approached.
  LocalRefinementResult approach(const Rigid& start, const Prior* prior, Scratch& scratch,
                                 int threads = 1) const;
  LocalRefinementResult finish(const Rigid& start, const LocalRefinementResult& approached,
                               const Prior* prior, Scratch& scratch, int threads = 1) const;

  /// Returns how many pairs of a refined pose say as much as one that is independent of all others,
  /// at least 1: found from both sides, they come twice, and neighbors share points and normals. It
  /// is the design effect of sampling in clusters (Kish 1965): the sum of squares of the cubes'
  /// summed g (see NormalEquations) over that of the pairs' own, cubes of three leaves.
  double design_effect(const LocalRefinementResult& refined, Scratch& scratch,
                       int threads = 1) const;

 private:
  /// Where an iteration stands.
  struct State {
    Rigid pose;
    double scale;      // Tukey's cut-off
    bool all_queries;  // or the first few
  };

  enum class Part { First, Second };
  LocalRefinementResult run(Part part, const Rigid& start, const Prior* prior, Scratch& scratch,
                            int threads, LocalRefinementResult out) const;
  void iterate(Part part, const Rigid& start, const Prior* prior, Scratch& scratch,
               ThreadTeam& team, LocalRefinementResult& out) const;
  void accumulate(const State& at, Scratch& scratch, ThreadTeam& team,
                  LocalRefinementResult& out) const;
  double reach(const State& at) const { return std::max(at.scale, settings_.reach * leaf_); }

  const LocalRefinementSettings settings_;
  const double leaf_;
  const Kernels& kernels_;
  const SurfaceMatcher matcher_;
};

}  // namespace emtr
