#include "fpfh.h"

#include <algorithm>

#include "fpfh_backends.h"

namespace emtr {

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
