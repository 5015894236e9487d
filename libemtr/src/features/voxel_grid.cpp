#include "voxel_grid.h"

#include <pcl/filters/voxel_grid.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "pcl_cloud.h"

namespace emtr {

Cloud voxel_grid(const Cloud& cloud, float leaf) {
  pcl::VoxelGrid<pcl::PointXYZ> filter;
  filter.setInputCloud(to_pcl(cloud));
  filter.setLeafSize(leaf, leaf, leaf);
  pcl::PointCloud<pcl::PointXYZ> out;
  filter.filter(out);
  return from_pcl(out);
}

std::size_t count_voxels(const Cloud& cloud, float leaf) {
  // PCL's binning, so that the two counts agree: floor(x * (1 / leaf)).
  const float inverse = 1.0f / leaf;
  const auto cell = [inverse](float v) { return static_cast<int>(std::floor(v * inverse)); };
  struct Axis {
    int low;
    std::size_t size;
  };
  const auto axis = [&](const std::vector<float>& v) {
    const auto [low, high] = std::minmax_element(v.begin(), v.end());
    return Axis{cell(*low), static_cast<std::size_t>(cell(*high) - cell(*low) + 1)};
  };
  const Axis ax = axis(cloud.x), ay = axis(cloud.y), az = axis(cloud.z);
  std::vector<bool> occupied(ax.size * ay.size * az.size);
  std::size_t count = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const auto at = [](int index, Axis a) { return static_cast<std::size_t>(index - a.low); };
    const std::size_t key =
        (at(cell(cloud.z[i]), az) * ay.size + at(cell(cloud.y[i]), ay)) * ax.size +
        at(cell(cloud.x[i]), ax);
    if (!occupied[key]) {
      occupied[key] = true;
      ++count;
    }
  }
  return count;
}

}  // namespace emtr
