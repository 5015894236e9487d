#pragma once

#include "correspondences/user_keypoints.h"

namespace emtr {

/// Matches that the caller handed in, and the points that they are of.
struct UserCorrespondences {
  FeatureClouds clouds;
  std::vector<Correspondence> correspondences;  ///< rows of `clouds`, in the caller's order
};

/// Reads `count` pairs (row of the source, row of the target). One that stands there twice is taken
/// once; of more than `most` so many are taken, evenly spread over the list. Throws Error, naming
/// the pair, on rows that do not exist or were dropped, and when fewer than 3 are left.
UserCorrespondences load_user_correspondences(const NormalizedPair& pair, const std::int32_t* rows,
                             std::size_t count, std::size_t most);

/// `most` of them or all, evenly spread, in their order.
std::vector<Correspondence> spread(const std::vector<Correspondence>& all, std::size_t most);

}  // namespace emtr
