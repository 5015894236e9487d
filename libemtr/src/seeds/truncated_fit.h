#pragma once

#include "correspondences/match_points.h"
#include "geometry/rigid.h"

namespace emtr {

/// A pose by truncated least squares, and the noise of the matches that it is made of.
struct TruncatedFit {
  Rigid pose;
  double noise = 0;      ///< standard deviation of one coordinate
  double threshold = 0;  ///< largest residual of an inlier
};

/// Fits a pose to the matches, where those with residuals beyond the threshold count nothing: by
/// graduated non-convexity (Yang et al., "Graduated Non-Convexity for Robust Spatial Perception",
/// RA-L 2020) from a pose near the answer. The threshold is estimated too, from the inliers' noise,
/// and is no less than `radius`, which is known to hold inliers.
TruncatedFit truncated_fit(const MatchPoints& matches, const Rigid& start, double radius);

}  // namespace emtr
