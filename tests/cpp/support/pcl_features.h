#pragma once

// PCL's templates are compiled in here, as they are in the library.
#define PCL_NO_PRECOMPILE
#include <pcl/features/fpfh_omp.h>
#include <pcl/features/normal_3d_omp.h>
#include <pcl/search/kdtree.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "features/fpfh.h"

namespace emtr_test {

/// What features = pcl is to be: PCL's classes one after the other, each with a kd-tree.
inline emtr::Features by_classes_of_pcl(const emtr::Cloud& cloud,
                                        const emtr::FeatureDefinition& definition) {
  using Points = pcl::PointCloud<pcl::PointXYZ>;
  using Tree = pcl::search::KdTree<pcl::PointXYZ>;
  auto points = pcl::make_shared<Points>();
  for (std::size_t i = 0; i < cloud.size(); ++i)
    points->push_back({cloud.x[i], cloud.y[i], cloud.z[i]});
  pcl::NormalEstimationOMP<pcl::PointXYZ, pcl::Normal> normal_estimation(2);
  normal_estimation.setInputCloud(points);
  normal_estimation.setSearchMethod(pcl::make_shared<Tree>());
  normal_estimation.setRadiusSearch(definition.normal_radius);
  const auto& [x, y, z] = definition.viewpoint;
  normal_estimation.setViewPoint(x, y, z);
  pcl::PointCloud<pcl::Normal> normals;
  normal_estimation.compute(normals);

  constexpr float none = std::numeric_limits<float>::quiet_NaN();
  emtr::Features out{std::vector<float>(3 * cloud.size(), none),
                     std::vector<float>(emtr::kFeatureSize * cloud.size(), none)};
  auto kept_points = pcl::make_shared<Points>();
  auto kept_normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!std::isfinite(normals[i].normal_x)) continue;
    kept.push_back(i);
    kept_points->push_back((*points)[i]);
    kept_normals->push_back(normals[i]);
    std::copy_n(normals[i].normal, 3, &out.normals[3 * i]);
  }
  if (kept.empty()) return out;
  pcl::FPFHEstimationOMP<pcl::PointXYZ, pcl::Normal, pcl::FPFHSignature33> estimation(2);
  estimation.setInputCloud(kept_points);
  estimation.setInputNormals(kept_normals);
  estimation.setSearchMethod(pcl::make_shared<Tree>());
  estimation.setRadiusSearch(definition.feature_radius);
  pcl::PointCloud<pcl::FPFHSignature33> signatures;
  estimation.compute(signatures);
  for (std::size_t k = 0; k < kept.size(); ++k) {
    const float* histogram = signatures[k].histogram;
    const float sum = std::accumulate(histogram, histogram + emtr::kFeatureSize, 0.0f);
    if (std::isfinite(sum) && sum > 0)
      std::copy_n(histogram, emtr::kFeatureSize, &out.descriptors[kept[k] * emtr::kFeatureSize]);
  }
  return out;
}

}  // namespace emtr_test
