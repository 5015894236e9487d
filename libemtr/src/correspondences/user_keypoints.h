#pragma once

#include <cstdint>
#include <vector>

#include "correspondences/matching.h"
#include "preprocessing/normalization.h"

namespace emtr {

/// The points of one cloud that take part in the matching, when the caller handed in descriptors or
/// the matches themselves.
struct FeatureCloud {
  Cloud points;                    ///< normalized frame
  std::size_t dimension = 0;       ///< numbers of a descriptor; 0 when the matches were handed in
  std::vector<float> descriptors;  ///< (n, dimension)
  std::vector<std::int32_t> rows;  ///< of the caller's array, ascending

  DescriptorRows view() const { return {descriptors, dimension}; }
};

struct FeatureClouds {
  FeatureCloud source, target;
};

/// More described points than this in a cloud are thinned for the matching, which compares all with
/// all.
constexpr std::size_t kMostFeatures = 20000;

/// Whether both clouds came with descriptors. Throws Error when only one of them did, or those of
/// one are of another dimension.
bool have_features(const NormalizedPair& pair);

/// The described points of both clouds; of a cloud with more than kMostFeatures of them one in each
/// cube of side `leaf`, see one_row_per_voxel().
FeatureClouds user_keypoints(const NormalizedPair& pair, double leaf);

}  // namespace emtr
