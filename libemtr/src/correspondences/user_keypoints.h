#pragma once

#include "preprocessing/keypoints.h"
#include "preprocessing/normalization.h"

namespace emtr {

struct KeypointPair {
  Keypoints source, target;
};

/// A cloud with more keypoints than this is downsampled for the matching, which compares all with
/// all.
constexpr std::size_t kMaximumKeypoints = 20000;

/// Tells whether both clouds came with descriptors. Throws Error when only one of them did or when
/// their dimensions differ.
bool has_user_keypoints(const NormalizedPair& pair);

/// Returns the keypoints of both clouds in the normalized frame. Of more than kMaximumKeypoints in
/// a cloud it keeps one for each voxel of side `leaf`, see one_row_per_voxel().
KeypointPair load_user_keypoints(const NormalizedPair& pair, double leaf);

}  // namespace emtr
