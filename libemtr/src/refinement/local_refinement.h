#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "kernels/kernels.h"
#include "neighbors/neighbors.h"
#include "priors/prior.h"
#include "geometry/rigid.h"
#include "util/thread_team.h"
#include "refinement/normal_equations.h"
#include "refinement/plane_to_plane.h"
#include "refinement/downsampled_surface.h"

namespace emtr {

/// How a pose is polished. Lengths are in leaves of the target's surface. The defaults are for the
/// last polish of one pose, a degree or two and 0.03 off, on fine surfaces: leaf 0.015, but no
/// finer than two spacings of the coarser cloud. coarse_refinement() is for many.
struct LocalRefinementSettings {
  double first_scale = 3;    ///< Tukey's cut-off of the residuals at the start; > 0
  double last_scale = 0.7;   ///< and at the end; > 0, at most first_scale
  double shrink = 0.6;       ///< the cut-off of an iteration by that of the one before; in (0, 1)
  double reach = 1.5;        ///< farthest match, but never below the cut-off in use; > 0. The
                             ///< neighbors' radius bounds it too
  double normal_gate = 0.7;  ///< least |cosine| between the normals of a match; in [0, 1)
  double softness = 3e-3;    ///< eps of PlaneToPlane: variance along normals by that in planes; in
                             ///< (0, 1). A match whose normals differ by 6 degrees counts half with
                             ///< 0.003; noisy scans like up to 0.03
  double step = 5e-3;        ///< done when a step (radians and shift together) is below so many
                             ///< leaves; > 0. Noisy matches keep changing places below 0.001
  int iterations = 25;       ///< at most; >= 1
  std::size_t queries = 6000;        ///< points of each cloud that look for a match, spread evenly
                                     ///< over those with a normal; >= 1
  std::size_t first_queries = 1500;  ///< the same while the cut-off still shrinks; >= 1
  bool both_ways = true;             ///< target points look for a match in the source too
  std::size_t minimum_inliers = 30;    ///< fewer hold no pose; >= 6
};

/// For ranking candidates that may be 10 degrees and 0.1 off, on surfaces of a few thousand points
/// each: the neighbors of the target need a radius of 4 leaves, those of the source are not asked.
LocalRefinementSettings coarse_refinement();

enum class Termination {
  Settled,       ///< the last step was as small as asked
  Iterations,    ///< it was not when they ran out: the pose is of use, but may still drift
  TooFewInliers  ///< nothing could be done: the pose is the one at the start
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
  NormalEquations sums;            ///< at the last look: what information() and hessian_spectrum() read
};

/// Polishes poses of one pair of surfaces; prepared once, then called for each start. Gauss-Newton
/// on SE(3) with matches looked up anew in each iteration, all sums in double and in an order that
/// does not depend on the threads. The surfaces are copied, the neighbors must outlive it.
class LocalRefinement {
 public:
  /// What one call at a time works in; keep one a thread, so that no call allocates but the first.
  struct Scratch {
    std::vector<float> x, y, z, squared;
    std::vector<std::int32_t> index;
    std::vector<NormalEquations> blocks;
  };

  /// Neighbors of the points of the two surfaces, with a radius of first_scale leaves (and of
  /// `reach` leaves when that is more); `near_source` may be null unless both_ways. Throws Error
  /// when a setting is out of its range, a surface is not whole, or its neighbors are missing.
  LocalRefinement(const Surface& source, const Surface& target, const Neighbors* near_source,
              const Neighbors* near_target, const LocalRefinementSettings& settings, const Kernels& kernels);

  /// Safe to call from several threads at once, each with its own scratch. `threads` share the
  /// work of this one call, which gives the same bits for any number. Throws Error when the start
  /// is not a finite rigid pose.
  /// With a prior, of which the start is a pose, each step is the best one within it, and the end
  /// an optimum among its poses.
  LocalRefinementResult operator()(const Rigid& start, const Prior* prior, Scratch& scratch,
                      int threads = 1) const;

  /// How many pairs of a polished pose say as much as one that is independent of all others, at
  /// least 1: found from both sides, they come twice, and neighbors share points and normals. It
  /// is the design effect of sampling in clusters (Kish 1965): the sum of squares of the cubes'
  /// summed g (see NormalEquations) over that of the pairs' own, cubes of three leaves.
  double design_effect(const LocalRefinementResult& refine_locally, Scratch& scratch) const;

 private:
  struct Side {
    std::vector<Oriented> points;       // of the whole surface
    std::vector<std::int32_t> queries;  // those that ask: a thinned part first, then the rest
    Cloud places;                       // of the queries
    std::size_t first = 0;              // how long the thinned part is
    const Neighbors* near = nullptr;    // of the other side's points
  };

  struct Look {
    Rigid pose;
    double scale;
    bool all;  // the queries, or the first few
  };

  static Side prepare(const Surface& surface, const Neighbors* near_other, const LocalRefinementSettings& settings);
  LocalRefinementResult refine_locally(const Rigid& start, const Prior* prior, Scratch& scratch, ThreadTeam& team) const;
  void look(const Look& at, Scratch& scratch, ThreadTeam& team, LocalRefinementResult& out) const;
  template <class Visit>
  void each_pair(const Look& at, bool reversed, std::size_t begin, std::size_t end,
                 std::size_t place, Scratch& scratch, const Visit& visit) const;

  LocalRefinementSettings settings_;
  double leaf_;
  Side source_, target_;
  const Kernels& kernels_;
};

}  // namespace emtr
