#pragma once

#include <cstdint>
#include <vector>

#include "correspondences/correspondence.h"
#include "correspondences/descriptor_rows.h"
#include "kernels/kernels.h"

namespace emtr {

/// Returns the pairs whose points are each among the k nearest of the other by descriptor (k = 1:
/// mutual nearest neighbors), without a ratio test: the `max_count` pairs with the smallest
/// distance between descriptors, in that order. Both sides have one dimension. Among points at one
/// distance the one with the smallest row is the nearest. Writes the number of all such pairs to
/// `found`, unless it is null.
std::vector<Correspondence> match_mutual(const DescriptorRows& source, const DescriptorRows& target,
                                         int k, std::size_t max_count, const Kernels& kernels,
                                         int threads, std::size_t* found = nullptr);

/// Returns the same pairs with the most distinctive first: those with the smallest ratio of the
/// distance between the descriptors to the distance to the tenth nearest, for both points. A scan
/// is full of planes and the like, whose descriptors are close to many others; such pairs, ordered
/// by distance alone, would leave no place for the rest.
std::vector<Correspondence> match_distinctive(const DescriptorRows& source,
                                              const DescriptorRows& target, int k,
                                              std::size_t max_count, const Kernels& kernels,
                                              int threads);

/// Returns the mutual nearest neighbors.
inline std::vector<Correspondence> match(const DescriptorRows& source, const DescriptorRows& target,
                                         std::size_t max_count, const Kernels& kernels, int threads,
                                         std::size_t* found = nullptr) {
  return match_mutual(source, target, 1, max_count, kernels, threads, found);
}

}  // namespace emtr
