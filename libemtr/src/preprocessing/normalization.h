#pragma once

#include <emtr/emtr.h>

#include "geometry/cloud.h"
#include "geometry/rigid.h"
#include "preprocessing/preprocessed_cloud.h"

namespace emtr {

/// The normalized frame: each cloud is centred on its own centroid, and both are divided by one
/// scale, the larger of the two radii, so that all points lie in the unit ball.
struct Normalization {
  double scale = 1;              ///< the user's unit
  double center_source[3] = {};  ///< the user's unit
  double center_target[3] = {};

  /// From a pose in the normalized frame to one in the user's unit, and back.
  Rigid to_user(const Rigid& pose) const;
  Rigid to_normalized(const Rigid& pose) const;
};

/// Both clouds in that frame, and what they were made from.
struct NormalizedPair {
  Normalization normalization;
  Cloud source, target;  ///< the base points; those of the larger cloud unchanged
  PreprocessedCloudPtr preprocessed_source, preprocessed_target;
};

/// All coordinates times a factor.
Cloud scaled(const Cloud& cloud, double factor);

NormalizedPair normalize(PreprocessedCloudPtr source, PreprocessedCloudPtr target);

/// Whether both clouds came with normals: then the side that they point to is known of both, and
/// the same. Beside estimated ones, given normals are no more than directions.
bool trust_normals(const NormalizedPair& pair);

/// Prepares the two clouds, named source and target, one after the other.
NormalizedPair normalize(const emtr_cloud& source, const emtr_cloud& target, int threads);

}  // namespace emtr
