#pragma once

#include "settings/settings.h"
#include "preprocessing/normalization.h"

namespace emtr {

/// The clouds that the tasks work on: both thinned by one leaf a density, the leaf found so that
/// a count of points is met, whatever the unit and the size of the input.
struct DownsampledClouds {
  double leaf_sparse = 0, leaf_dense = 0;  ///< normalized frame
  Cloud source_sparse, target_sparse;
  Cloud source_dense, target_dense;
  Cloud source_normals, target_normals;  ///< of the dense clouds, if the caller gave some (unit)
};

DownsampledClouds downsample(const NormalizedPair& pair, const Settings& settings);

/// The dense clouds alone: the sparse ones stay empty.
DownsampledClouds downsample_dense(const NormalizedPair& pair, const Settings& settings);

}  // namespace emtr
