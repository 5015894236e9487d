#include "kdtree_neighbors.h"

#include <pcl/kdtree/kdtree_flann.h>

#include "pcl_cloud.h"

namespace emtr {
namespace {

class KdTreeNeighbors final : public Neighbors {
 public:
  KdTreeNeighbors(const Cloud& cloud, float radius) : cloud_(cloud), limit_(radius * radius) {
    tree_.setInputCloud(to_pcl(cloud));
  }

  void squared_distances(const PointsView& queries, float* out) const override {
    std::vector<std::int32_t> index(queries.size);
    nearest(queries, index.data(), out);
  }

  void nearest(const PointsView& q, std::int32_t* index, float* squared) const override {
    pcl::Indices found(1);
    std::vector<float> distance(1);
    for (std::size_t i = 0; i < q.size; ++i) {
      const float x = q.x[i], y = q.y[i], z = q.z[i];
      tree_.nearestKSearch(pcl::PointXYZ(x, y, z), 1, found, distance);
      const auto k = static_cast<std::size_t>(found[0]);
      const float d = squared_distance(x - cloud_.x[k], y - cloud_.y[k], z - cloud_.z[k]);
      const bool near = d < limit_;
      squared[i] = near ? d : limit_;
      index[i] = near ? found[0] : -1;
    }
  }

 private:
  Cloud cloud_;
  float limit_;
  pcl::KdTreeFLANN<pcl::PointXYZ> tree_;
};

}  // namespace

std::unique_ptr<Neighbors> make_kdtree(const Cloud& cloud, float radius) {
  return std::make_unique<KdTreeNeighbors>(cloud, radius);
}

}  // namespace emtr
