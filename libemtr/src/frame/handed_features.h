#pragma once

#include <cstdint>
#include <vector>

#include "../features/matching.h"
#include "frame.h"

namespace emtr {

/// The points of one cloud that take part in the matching, when the caller handed in descriptors or
/// the matches themselves.
struct FeatureCloud {
  Cloud points;                    ///< normalised frame
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
bool have_features(const NormalisedPair& pair);

/// The described points of both clouds; of a cloud with more than kMostFeatures of them one in each
/// cube of side `leaf`, see one_per_cube().
FeatureClouds handed_features(const NormalisedPair& pair, double leaf);

}  // namespace emtr
