#pragma once

#include "preprocessing/normalization.h"
#include "settings/settings.h"

namespace emtr {

/// The clouds that the tasks work on: a sparse and a dense pair. One leaf downsamples both clouds
/// of a pair; it is found so that a count of points is met, whatever the unit and the size of the
/// input.
struct DownsampledClouds {
  double leaf_sparse = 0, leaf_dense = 0;  ///< normalized frame
  Cloud source_sparse, target_sparse;
  Cloud source_dense, target_dense;
  Cloud source_normals, target_normals;  ///< unit, of the dense clouds, if the user provided some
};

DownsampledClouds downsample(const NormalizedPair& pair, const Settings& settings);

/// Makes the dense clouds alone and leaves the sparse ones empty.
DownsampledClouds downsample_dense(const NormalizedPair& pair, const Settings& settings);

}  // namespace emtr
