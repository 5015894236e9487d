#include "candidates/fallback_search.h"

#include "correspondences/matching.h"
#include "preprocessing/dense_features.h"
#include "seeds/seeds.h"

namespace emtr {
namespace {

constexpr int kNearest = 3;  // of each other, to be a match

std::shared_ptr<const Features> describe_towards(const NormalizedPair& pair, int side,
                                                 const DownsampledClouds& clouds,
                                                 const std::optional<Viewpoint>& viewpoint,
                                                 const Settings& settings, const Kernels& kernels,
                                                 int threads) {
  FeatureDefinition definition = feature_definition(settings, clouds.leaf_dense);
  definition.trust_normals = trust_normals(pair);
  definition.backend = FeatureBackend::Simd;
  if (viewpoint) definition.viewpoint = viewpoint->in_float();
  return dense_features(pair, side, clouds, definition, kernels, threads);
}

}  // namespace

std::vector<Rigid> poses_of_matches(const Cloud& source, const Cloud& target,
                                    const std::vector<Correspondence>& matches, double leaf,
                                    const Settings& settings, const Kernels& kernels, int threads) {
  const double threshold = settings.seed_threshold * leaf;
  const Consistency consistency(source, target, matches, threshold, kernels, threads);
  std::vector<Rigid> out;
  for (const Seed& seed : find_seeds(consistency, threshold,
                                     static_cast<std::size_t>(settings.fallback_seeds), threads))
    out.push_back(seed.pose);
  return out;
}

std::vector<Rigid> find_fallback_seeds(const NormalizedPair& pair,
                                       const std::optional<Viewpoint>& source_viewpoint,
                                       const std::optional<Viewpoint>& target_viewpoint,
                                       const Settings& settings, const Kernels& kernels,
                                       int threads) {
  Settings many = settings;
  many.dense_points = settings.fallback_points;
  const DownsampledClouds d = downsample_dense(pair, many);
  const auto source = describe_towards(pair, 0, d, source_viewpoint, settings, kernels, threads);
  const auto target = describe_towards(pair, 1, d, target_viewpoint, settings, kernels, threads);

  std::vector<Rigid> out;
  const auto search = [&](const Features& source_features) {
    const auto matches = match_distinctive(
        source_features, *target, kNearest,
        static_cast<std::size_t>(settings.fallback_correspondences), kernels, threads);
    const auto poses = poses_of_matches(d.source_dense, d.target_dense, matches, d.leaf_dense,
                                        settings, kernels, threads);
    out.insert(out.end(), poses.begin(), poses.end());
  };
  search(*source);
  const auto believed = [](const std::optional<Viewpoint>& v) { return v && v->trust == 1; };
  if (!trust_normals(pair) && !(believed(source_viewpoint) && believed(target_viewpoint)))
    search(mirrored(*source));
  return out;
}

}  // namespace emtr
