#include "fpfh.h"

#include <algorithm>

#include "fpfh_backends.h"

namespace emtr {

FeatureDefinition feature_definition(const Settings& settings, double leaf) {
  FeatureDefinition out;
  out.normal_radius = settings.normal_radius * leaf;
  out.feature_radius = settings.feature_radius * leaf;
  out.backend = static_cast<FeatureBackend>(settings.features);
  return out;
}

Features describe(const Cloud& cloud, const FeatureDefinition& definition, const Kernels& kernels,
                  int threads) {
  if (definition.backend == FeatureBackend::Simd)
    return describe_by_kernels(cloud, definition, kernels, threads);
  return describe_by_pcl(cloud, definition, threads);
}

Features mirrored(const Features& features) {
  Features out = features;
  for (float& component : out.normals) component = -component;
  for (auto row = out.descriptors.begin(); row != out.descriptors.end(); row += kFeatureSize) {
    std::reverse(row, row + kBins);
    std::reverse(row + 2 * kBins, row + 3 * kBins);
  }
  return out;
}

}  // namespace emtr
