#pragma once

#include <cstdint>
#include <vector>

#include "fpfh.h"

namespace emtr {

/// Rows of a source point and a target point held to be the same place.
struct Correspondence {
  std::int32_t source, target;
};

/// Pairs of which each point is among the k nearest of the other in FPFH space (k = 1: mutual
/// nearest neighbours), no ratio test; of points at one distance the smallest row is the nearer.
/// The `most` pairs with the smallest distance between descriptors, in that order; `found`, unless
/// null, gets how many there were.
std::vector<Correspondence> match_mutual(const Features& source, const Features& target, int k,
                                         std::size_t most, const Kernels& kernels, int threads,
                                         std::size_t* found = nullptr);

/// Mutual nearest neighbours.
inline std::vector<Correspondence> match(const Features& source, const Features& target,
                                         std::size_t most, const Kernels& kernels, int threads,
                                         std::size_t* found = nullptr) {
  return match_mutual(source, target, 1, most, kernels, threads, found);
}

}  // namespace emtr
