#include "neighbors/kdtree_neighbors.h"

#include <pcl/kdtree/kdtree_flann.h>

#include <algorithm>
#include <cmath>

#include "geometry/pcl_cloud.h"

namespace emtr {
namespace {

class KdTreeNeighbors final : public Neighbors {
 public:
  KdTreeNeighbors(const Cloud& cloud, float radius) : cloud_(cloud), limit_(radius * radius) {
    tree_.setInputCloud(to_pcl(cloud));
  }

  void squared_distances(const PointsView& q, float* out) const override {
    pcl::Indices found(1);
    std::vector<float> distance(1);
    for (std::size_t i = 0; i < q.size; ++i) {
      tree_.nearestKSearch(pcl::PointXYZ(q.x[i], q.y[i], q.z[i]), 1, found, distance);
      out[i] = std::min(limit_, squared(q, i, found[0]));
    }
  }

  /// Compares again all points that are as near but for rounding: the tree returns any of several
  /// at one distance.
  void nearest(const PointsView& q, std::int32_t* index, float* out) const override {
    pcl::Indices found(1);
    std::vector<float> distance(1);
    for (std::size_t i = 0; i < q.size; ++i) {
      const pcl::PointXYZ point(q.x[i], q.y[i], q.z[i]);
      tree_.nearestKSearch(point, 1, found, distance);
      out[i] = limit_;
      index[i] = -1;
      if (!(squared(q, i, found[0]) < limit_)) continue;
      const double reach = std::sqrt(static_cast<double>(distance[0])) * (1 + 1e-5) + 1e-9;
      tree_.radiusSearch(point, reach, found, distance);
      for (const pcl::index_t k : found) {
        const float d = squared(q, i, k);
        if (d < out[i] || (d == out[i] && k < index[i])) {
          out[i] = d;
          index[i] = k;
        }
      }
    }
  }

 private:
  float squared(const PointsView& q, std::size_t i, pcl::index_t candidate) const {
    const auto k = static_cast<std::size_t>(candidate);
    return squared_distance(q.x[i] - cloud_.x[k], q.y[i] - cloud_.y[k], q.z[i] - cloud_.z[k]);
  }

  Cloud cloud_;
  float limit_;
  pcl::KdTreeFLANN<pcl::PointXYZ> tree_;
};

}  // namespace

std::unique_ptr<Neighbors> make_kdtree(const Cloud& cloud, float radius) {
  return std::make_unique<KdTreeNeighbors>(cloud, radius);
}

}  // namespace emtr
