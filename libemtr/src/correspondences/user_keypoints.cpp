#include "correspondences/user_keypoints.h"

#include <string>

#include "util/error.h"

namespace emtr {
namespace {

Keypoints normalized_keypoints(const PreprocessedCloud& cloud, double scale, double leaf) {
  const double factor = cloud.radius / scale;
  Keypoints out = cloud.keypoints.rows.size() > kMaximumKeypoints
                      ? downsample(cloud.keypoints, static_cast<float>(leaf / factor))
                      : cloud.keypoints;
  out.points = scale_cloud(out.points, factor);
  return out;
}

}  // namespace

bool has_user_keypoints(const NormalizedPair& pair) {
  const Keypoints &source = pair.preprocessed_source->keypoints,
                  &target = pair.preprocessed_target->keypoints;
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

KeypointPair load_user_keypoints(const NormalizedPair& pair, double leaf) {
  const double scale = pair.normalization.scale;
  return {normalized_keypoints(*pair.preprocessed_source, scale, leaf),
          normalized_keypoints(*pair.preprocessed_target, scale, leaf)};
}

}  // namespace emtr
