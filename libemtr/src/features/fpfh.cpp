#include "features/fpfh.h"

#include <algorithm>

#include "features/fpfh_backends.h"
#include "geometry/surface.h"

namespace emtr {

FeatureDefinition feature_definition(const Settings& settings, double leaf) {
  FeatureDefinition out;
  out.normal_radius = settings.normal_radius * leaf;
  out.feature_radius = settings.feature_radius * leaf;
  out.backend = static_cast<FeatureBackend>(settings.features);
  return out;
}

std::vector<double> FeatureDefinition::numbers() const {
  std::vector<double> out = {normal_radius, feature_radius, static_cast<double>(backend),
                             static_cast<double>(trust_normals), static_cast<double>(normals_only)};
  out.insert(out.end(), viewpoint.begin(), viewpoint.end());
  return out;
}

namespace {

Features describe_oriented(const Cloud& cloud, const FeatureDefinition& definition,
                           const Kernels& kernels, int threads, const Cloud& normals) {
  if (normals.size() && definition.normals_only) {
    Features out;
    for (std::size_t i = 0; i < cloud.size(); ++i)
      out.normals.insert(out.normals.end(), {normals.x[i], normals.y[i], normals.z[i]});
    return out;
  }
  if (definition.backend == FeatureBackend::Simd)
    return describe_by_kernels(cloud, definition, kernels, threads, normals);
  return describe_by_pcl(cloud, definition, threads, normals);
}

}  // namespace

Features describe(const Cloud& cloud, const FeatureDefinition& definition, const Kernels& kernels,
                  int threads, const Cloud& normals) {
  if (normals.size() == 0 || definition.trust_normals)
    return describe_oriented(cloud, definition, kernels, threads, normals);
  Cloud oriented = normals;
  orient_normals(cloud, definition.viewpoint, oriented);
  return describe_oriented(cloud, definition, kernels, threads, oriented);
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
