#pragma once

#include <cstddef>

namespace emtr {

/// How a pose is refined. Lengths are in leaves of the target's surface. The defaults are for the
/// last refinement of one pose, a degree or two and 0.03 off, on fine surfaces: leaf 0.015, but no
/// finer than two spacings of the coarser cloud. coarse_refinement() is for many.
struct LocalRefinementSettings {
  double first_scale = 3;    ///< Tukey's cut-off of the residuals at the start; > 0
  double last_scale = 0.7;   ///< and at the end; > 0, at most first_scale
  double shrink = 0.6;       ///< the cut-off of an iteration by that of the one before; in (0, 1)
  double reach = 1.5;        ///< farthest match, but never below the cut-off in use; > 0. The
                             ///< neighbors' radius bounds it too
  double normal_gate = 0.7;  ///< minimum |cosine| between the normals of a match; in [0, 1)
  double softness = 3e-3;    ///< eps of PlaneToPlane: variance along normals by that in planes; in
                             ///< (0, 1). A match whose normals differ by 6 degrees counts half with
                             ///< 0.003; noisy scans like up to 0.03
  double step = 5e-3;        ///< converged when a step (radians and translation together) is below
                             ///< so many leaves; > 0. Noisy matches keep changing below 0.001
  int iterations = 25;       ///< at most; >= 1
  std::size_t queries = 6000;        ///< points of each cloud that look for a match, spread evenly
                                     ///< over those with a normal; >= 1
  std::size_t first_queries = 1500;  ///< the same while the cut-off still shrinks; >= 1
  bool both_ways = true;             ///< target points look for a match in the source too
  std::size_t minimum_inliers = 30;  ///< fewer cannot constrain a pose; >= 6
};

/// Returns settings for ranking candidates that may be 10 degrees and 0.1 off, on surfaces of a few
/// thousand points each: the neighbors of the target need a radius of 4 leaves, those of the source
/// are not asked.
LocalRefinementSettings coarse_refinement();

/// Returns the settings; throws Error when one is out of its range.
const LocalRefinementSettings& validated(const LocalRefinementSettings& settings);

}  // namespace emtr
