#pragma once

#include <vector>

#include "geometry/rigid.h"
#include "seeds/consistency.h"

namespace emtr {

/// A pose that a consistent subset of the correspondences agrees on.
struct Seed {
  Rigid pose;
  std::size_t inliers;  ///< correspondences with |q - (R p + t)| < threshold
};

/// Poses from the correspondences that agree with the most others, after the second order spatial
/// compatibility of Chen et al., "SC2-PCR", CVPR 2022: around each of up to `most` correspondences
/// the ones that share the most consistent partners with it, their rigid motion, and that motion's
/// own inliers. The one with the most inliers first; near-copies are left out.
std::vector<Seed> find_seeds(const Consistency& consistency, double threshold, std::size_t most,
                             int threads);

}  // namespace emtr
