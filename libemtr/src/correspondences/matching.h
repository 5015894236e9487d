#pragma once

#include <cstdint>
#include <vector>

#include "features/fpfh.h"

namespace emtr {

/// Rows of a source point and a target point held to be the same place.
struct Correspondence {
  std::int32_t source, target;
};

/// Descriptors of the points of a cloud, row-major (count, dimension), someone else's memory. A
/// point whose first number is NaN has none.
struct DescriptorRows {
  const float* values;
  std::size_t count, dimension;

  DescriptorRows(const std::vector<float>& numbers, std::size_t size)
      : values(numbers.data()), count(numbers.size() / size), dimension(size) {}
  DescriptorRows(const Features& features)  // NOLINT: the descriptors of the features
      : DescriptorRows(features.descriptors, kFeatureSize) {}

  const float* row(std::size_t i) const { return values + i * dimension; }
  bool valid(std::size_t i) const { return *row(i) == *row(i); }
};

/// Pairs of which each point is among the k nearest of the other by descriptor (k = 1: mutual
/// nearest neighbors; both of one dimension), no ratio test; of points at one distance the
/// smallest row is the nearer. The `most` pairs with the smallest distance between descriptors, in
/// that order; `found`, unless null, gets how many there were.
std::vector<Correspondence> match_mutual(const DescriptorRows& source, const DescriptorRows& target,
                                         int k, std::size_t most, const Kernels& kernels,
                                         int threads, std::size_t* found = nullptr);

/// The same pairs, those first that stand out: by the distance between the descriptors over that to
/// the tenth nearest, of both points. On planes and the like, of which a scan is full, descriptors
/// are near to many; ordered by distance alone such pairs would leave no place for others.
std::vector<Correspondence> match_distinctive(const DescriptorRows& source,
                                           const DescriptorRows& target, int k, std::size_t most,
                                           const Kernels& kernels, int threads);

/// Mutual nearest neighbors.
inline std::vector<Correspondence> match(const DescriptorRows& source, const DescriptorRows& target,
                                         std::size_t most, const Kernels& kernels, int threads,
                                         std::size_t* found = nullptr) {
  return match_mutual(source, target, 1, most, kernels, threads, found);
}

}  // namespace emtr
