#include "resolution.h"

#include <pcl/kdtree/kdtree_flann.h>

#include <algorithm>
#include <cmath>

#include "pcl_cloud.h"

namespace emtr {

double mean_resolution(const Cloud& cloud, std::size_t most) {
  const auto points = to_pcl(cloud);
  pcl::KdTreeFLANN<pcl::PointXYZ> tree;
  tree.setInputCloud(points);
  pcl::Indices index(2);
  std::vector<float> squared(2);
  const std::size_t step = std::max<std::size_t>(1, cloud.size() / most);
  double sum = 0;
  std::size_t asked = 0;
  for (std::size_t i = 0; i < cloud.size(); i += step, ++asked) {
    tree.nearestKSearch((*points)[i], 2, index, squared);
    sum += std::sqrt(static_cast<double>(squared[1]));
  }
  return sum / static_cast<double>(asked);
}

}  // namespace emtr
