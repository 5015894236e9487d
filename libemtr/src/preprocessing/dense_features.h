#pragma once

#include <memory>
#include <vector>

#include "features/fpfh.h"
#include "preprocessing/downsampling.h"

namespace emtr {

/// Returns all that the features of a dense cloud depend on, besides the cloud that it was
/// downsampled from.
std::vector<double> arguments_of_features(const FeatureDefinition& definition, double leaf);

/// Describes the dense cloud of one side, 0 the source; from the memory of its preprocessed cloud
/// where that was described by the same arguments before.
std::shared_ptr<const Features> dense_features(const NormalizedPair& pair, int side,
                                               const DownsampledClouds& clouds,
                                               const FeatureDefinition& definition,
                                               const Kernels& kernels, int threads);

}  // namespace emtr
