#include "preprocessing/dense_features.h"

namespace emtr {

std::vector<double> arguments_of_features(const FeatureDefinition& definition, double leaf) {
  std::vector<double> out = definition.numbers();
  out.push_back(leaf);
  return out;
}

std::shared_ptr<const Features> dense_features(const NormalizedPair& pair, int side,
                                               const DownsampledClouds& clouds,
                                               const FeatureDefinition& definition,
                                               const Kernels& kernels, int threads) {
  const Cloud& cloud = side == 0 ? clouds.source_dense : clouds.target_dense;
  const Cloud& normals = side == 0 ? clouds.source_normals : clouds.target_normals;
  return pair.remembered<Features>(side, arguments_of_features(definition, clouds.leaf_dense), [&] {
    return describe(cloud, definition, kernels, threads, normals);
  });
}

}  // namespace emtr
