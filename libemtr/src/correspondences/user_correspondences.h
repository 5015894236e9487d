#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "correspondences/correspondence.h"
#include "correspondences/match_points.h"
#include "correspondences/user_keypoints.h"

namespace emtr {

/// Correspondences that the user provided, and the points that they name.
struct UserCorrespondences {
  KeypointPair keypoints;                          ///< without descriptors
  std::vector<Correspondence> correspondences;     ///< rows of `keypoints`, in the user's order
  MatchPoints matches;                             ///< the ends of all of them, see kMaximumMatches
  std::size_t named_source = 0, named_target = 0;  ///< different points that all of them name
};

/// The poses that matches agree on are searched among so many of them.
constexpr std::size_t kMaximumMatches = 20000;

/// Reads `count` pairs (row of the source, row of the target). Takes each pair once and, of more
/// than `max_count`, as many evenly selected ones; none of strays. Throws Error, naming the pair,
/// on rows that do not exist or are not finite, and when fewer than 3 pairs are left.
UserCorrespondences load_user_correspondences(const NormalizedPair& pair, const std::int32_t* rows,
                                              std::size_t count, std::size_t max_count);

/// Returns `max_count` of them, evenly selected and in their order, or all if there are no more.
std::vector<Correspondence> select_evenly(const std::vector<Correspondence>& all,
                                          std::size_t max_count);

}  // namespace emtr
