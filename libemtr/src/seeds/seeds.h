#pragma once

#include <vector>

#include "geometry/rigid.h"
#include "seeds/consistency.h"

namespace emtr {

/// A pose on which a consistent subset of the correspondences agrees.
struct Seed {
  Rigid pose;
  std::size_t inliers;  ///< correspondences with |q - (R p + t)| < threshold
};

/// Returns the poses of up to `max_count` consistent subsets of the correspondences, the one with
/// the most inliers first, by the second order spatial compatibility of Chen et al., "SC2-PCR",
/// CVPR 2022. Each subset has a center, a correspondence with much support, and those that share
/// the most consistent correspondences with the center. The pose is the subset's rigid motion,
/// refitted to its own inliers. Centers close to one another make one seed.
std::vector<Seed> find_seeds(const Consistency& consistency, double threshold,
                             std::size_t max_count, int threads);

}  // namespace emtr
