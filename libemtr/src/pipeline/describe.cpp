#include <memory>
#include <optional>
#include <vector>

#include "pipeline/problem_stages.h"
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
  const auto described = [&](int side, const Cloud& cloud, const Cloud& normals,
                             const std::optional<Viewpoint>& sensor) {
    FeatureDefinition of_cloud = definition;
    if (sensors.both())
      for (std::size_t a = 0; a < 3; ++a) of_cloud.viewpoint[a] = static_cast<float>(sensor->at[a]);
    std::vector<double>& by = problem.features_by[side];
    by = of_cloud.numbers();
    by.push_back(clouds.leaf_dense);
    return *problem.pair.remembered<Features>(side, by, [&] {
      return describe(cloud, of_cloud, problem.kernels, thread_count(problem.settings), normals);
    });
  };
  problem.source_features =
      described(0, clouds.source_dense, clouds.source_normals, sensors.source);
  problem.target_features =
      described(1, clouds.target_dense, clouds.target_normals, sensors.target);
}

}  // namespace emtr
