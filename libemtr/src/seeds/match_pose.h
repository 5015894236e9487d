#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "correspondences/match_points.h"
#include "geometry/rigid.h"
#include "kernels/kernels.h"

namespace emtr {

/// A pose that some of the matches agree on.
struct MatchPose {
  Rigid pose;
  double noise = 0;       ///< of a coordinate of the inliers, standard deviation
  double threshold = 0;   ///< largest residual of an inlier
  double log_chance = 0;  ///< see Chance::log_expected(), of the most telling set of matches
  std::vector<std::uint32_t> inliers;
};

/// Finds the pose that the matches agree on least by chance, and one that they agree on nearly as
/// well, if there is one: at most two, the better one first; without inliers when no three are
/// consistent. It searches triangles of consistent matches at growing widths of noise, in subsets
/// of the matches when they are many, and fits the best of them to all matches by truncated least
/// squares.
std::vector<MatchPose> find_match_poses(const MatchPoints& matches, const Kernels& kernels,
                                        int threads);

/// Returns what the matches say of a pose of any origin.
MatchPose rate_match_pose(const MatchPoints& matches, const Rigid& pose);

}  // namespace emtr
