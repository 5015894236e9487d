#include <pcl/features/fpfh_omp.h>
#include <pcl/features/normal_3d_omp.h>
#include <pcl/search/kdtree.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fpfh_backends.h"
#include "pcl_cloud.h"

namespace emtr {
namespace {

using Points = pcl::PointCloud<pcl::PointXYZ>;
using Normals = pcl::PointCloud<pcl::Normal>;
using Tree = pcl::search::KdTree<pcl::PointXYZ>;
constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

Normals::Ptr estimate_normals(const Points::Ptr& points, const FeatureDefinition& definition,
                              int threads) {
  pcl::NormalEstimationOMP<pcl::PointXYZ, pcl::Normal> estimation(
      static_cast<unsigned int>(threads));
  estimation.setInputCloud(points);
  estimation.setSearchMethod(pcl::make_shared<Tree>());
  estimation.setRadiusSearch(definition.normal_radius);
  const auto& [x, y, z] = definition.viewpoint;
  estimation.setViewPoint(x, y, z);
  auto normals = pcl::make_shared<Normals>();
  estimation.compute(*normals);
  return normals;
}

}  // namespace

Features describe_by_pcl(const Cloud& cloud, const FeatureDefinition& definition, int threads) {
  const std::size_t n = cloud.size();
  const auto points = to_pcl(cloud);
  const auto normals = estimate_normals(points, definition, threads);

  // FPFH must not meet a NaN, so it sees only the points that have a normal.
  auto kept_points = pcl::make_shared<Points>();
  auto kept_normals = pcl::make_shared<Normals>();
  std::vector<std::size_t> kept;
  Features features{std::vector<float>(3 * n, kNone), std::vector<float>(kFeatureSize * n, kNone)};
  for (std::size_t i = 0; i < n; ++i) {
    const pcl::Normal& normal = (*normals)[i];
    if (!std::isfinite(normal.normal_x)) continue;
    kept.push_back(i);
    kept_points->push_back((*points)[i]);
    kept_normals->push_back(normal);
    std::copy_n(normal.normal, 3, &features.normals[3 * i]);
  }
  if (kept.empty()) return features;

  pcl::FPFHEstimationOMP<pcl::PointXYZ, pcl::Normal, pcl::FPFHSignature33> estimation(
      static_cast<unsigned int>(threads));
  estimation.setInputCloud(kept_points);
  estimation.setInputNormals(kept_normals);
  estimation.setSearchMethod(pcl::make_shared<Tree>());
  estimation.setRadiusSearch(definition.feature_radius);
  pcl::PointCloud<pcl::FPFHSignature33> signatures;
  estimation.compute(signatures);

  for (std::size_t k = 0; k < kept.size(); ++k) {
    const float* histogram = signatures[k].histogram;
    // A point alone in its neighbourhood gets an empty histogram, which would match any other.
    const float sum = std::accumulate(histogram, histogram + kFeatureSize, 0.0f);
    if (std::isfinite(sum) && sum > 0)
      std::copy_n(histogram, kFeatureSize, &features.descriptors[kept[k] * kFeatureSize]);
  }
  return features;
}

}  // namespace emtr
