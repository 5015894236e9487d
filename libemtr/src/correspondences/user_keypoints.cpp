#include "correspondences/user_keypoints.h"

#include <string>
#include <utility>

#include "util/error.h"

namespace emtr {
namespace {

FeatureCloud feature_cloud(const PreprocessedCloud& cloud, double scale, double leaf) {
  const double factor = cloud.radius / scale;
  Keypoints from = cloud.described.rows.size() > kMostFeatures
                             ? thinned(cloud.described, static_cast<float>(leaf / factor))
                             : cloud.described;
  return {scaled(from.points, factor), from.dimension, std::move(from.descriptors),
          std::move(from.rows)};
}

}  // namespace

bool have_features(const NormalizedPair& pair) {
  const Keypoints &source = pair.preprocessed_source->described,
                        &target = pair.preprocessed_target->described;
  if (!source != !target)
    throw Error(EMTR_ERROR_ARGUMENT, std::string("features are given for the ") +
                                         (source ? "source" : "target") +
                                         " cloud only, expected for both or none");
  if (source.dimension != target.dimension)
    throw Error(EMTR_ERROR_ARGUMENT, "features have " + std::to_string(source.dimension) +
                                         " numbers in the source cloud and " +
                                         std::to_string(target.dimension) +
                                         " in the target cloud, expected as many in both");
  return static_cast<bool>(source);
}

FeatureClouds user_keypoints(const NormalizedPair& pair, double leaf) {
  return {feature_cloud(*pair.preprocessed_source, pair.normalization.scale, leaf),
          feature_cloud(*pair.preprocessed_target, pair.normalization.scale, leaf)};
}

}  // namespace emtr
