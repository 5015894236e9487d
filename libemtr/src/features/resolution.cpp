#include "resolution.h"

#include <pcl/kdtree/kdtree_flann.h>

#include <cmath>

#include "pcl_cloud.h"

namespace emtr {

double mean_resolution(const Cloud& cloud) {
  const auto points = to_pcl(cloud);
  pcl::KdTreeFLANN<pcl::PointXYZ> tree;
  tree.setInputCloud(points);
  pcl::Indices index(2);
  std::vector<float> squared(2);
  double sum = 0;
  for (const auto& point : *points) {
    tree.nearestKSearch(point, 2, index, squared);
    sum += std::sqrt(static_cast<double>(squared[1]));
  }
  return sum / static_cast<double>(points->size());
}

}  // namespace emtr
