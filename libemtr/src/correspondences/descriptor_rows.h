#pragma once

#include <cstdint>
#include <vector>

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

}  // namespace emtr
