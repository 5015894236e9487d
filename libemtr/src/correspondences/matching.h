#pragma once

#include <cstdint>
#include <vector>

#include "correspondences/correspondence.h"
#include "features/fpfh.h"
#include "preprocessing/keypoints.h"

namespace emtr {

/// A view of the descriptors of a cloud's points, row-major (count, dimension). A point whose first
/// number is NaN has none.
struct DescriptorRows {
  const float* values;
  std::size_t count, dimension;

  DescriptorRows(const std::vector<float>& numbers, std::size_t size)
      : values(numbers.data()), count(numbers.size() / size), dimension(size) {}
  DescriptorRows(const Features& features)  // NOLINT: the descriptors of the features
      : DescriptorRows(features.descriptors, kFeatureSize) {}
  DescriptorRows(const Keypoints& keypoints)  // NOLINT: the descriptors of the keypoints
      : DescriptorRows(keypoints.descriptors, keypoints.dimension) {}

  const float* row(std::size_t i) const { return values + i * dimension; }
  bool valid(std::size_t i) const { return *row(i) == *row(i); }
};

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
