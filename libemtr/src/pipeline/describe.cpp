#include <memory>
#include <optional>

#include "pipeline/problem_stages.h"
#include "preprocessing/dense_features.h"
#include "ranking/given_viewpoints.h"

namespace emtr {

void load_user_keypoints(Problem& problem) {
  const bool features = has_user_keypoints(problem.pair);  // refuses bad ones in any case
  if (!problem.user_matches.correspondences.empty())
    problem.user_keypoints = std::make_unique<KeypointPair>(problem.user_matches.keypoints);
  else if (features)
    problem.user_keypoints = std::make_unique<KeypointPair>(
        load_user_keypoints(problem.pair, problem.downsampled.leaf_dense));
}

void describe_clouds(Problem& problem) {
  const DownsampledClouds& clouds = problem.downsampled;
  FeatureDefinition definition = feature_definition(problem.settings, clouds.leaf_dense);
  definition.trust_normals = trust_normals(problem.pair);
  definition.normals_only = problem.user_keypoints != nullptr;
  // One rule for both clouds: normals face the sensors only where both positions are known.
  const GivenViewpoints sensors(problem.settings, problem.pair.normalization);
  const auto described = [&](int side, const std::optional<Viewpoint>& sensor) {
    FeatureDefinition of_cloud = definition;
    if (sensors.both()) of_cloud.viewpoint = sensor->in_float();
    problem.features_by[side] = arguments_of_features(of_cloud, clouds.leaf_dense);
    return dense_features(problem.pair, side, clouds, of_cloud, problem.kernels,
                          thread_count(problem.settings));
  };
  problem.source_features = described(0, sensors.source);
  problem.target_features = described(1, sensors.target);
}

}  // namespace emtr
