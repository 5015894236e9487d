#include "neighbors/nearest_point.h"

#include <pcl/kdtree/kdtree_flann.h>

#include <utility>
#include <vector>

#include "geometry/pcl_cloud.h"

namespace emtr {

struct NearestPoint::Tree : pcl::KdTreeFLANN<pcl::PointXYZ> {};

NearestPoint::NearestPoint(const Cloud& cloud) {
  auto tree = std::make_unique<Tree>();
  tree->setInputCloud(to_pcl(cloud));
  tree_ = std::move(tree);
}

NearestPoint::~NearestPoint() = default;

std::size_t NearestPoint::operator()(const float place[3]) const {
  pcl::Indices index(1);
  std::vector<float> squared(1);
  tree_->nearestKSearch(pcl::PointXYZ(place[0], place[1], place[2]), 1, index, squared);
  return static_cast<std::size_t>(index[0]);
}

}  // namespace emtr
