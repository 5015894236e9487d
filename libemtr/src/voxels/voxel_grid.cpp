#include "voxels/voxel_grid.h"

#include <pcl/filters/voxel_grid.h>

#include "geometry/pcl_cloud.h"

namespace emtr {

Cloud voxel_grid(const Cloud& cloud, float leaf) {
  pcl::VoxelGrid<pcl::PointXYZ> filter;
  filter.setInputCloud(to_pcl(cloud));
  filter.setLeafSize(leaf, leaf, leaf);
  pcl::PointCloud<pcl::PointXYZ> out;
  filter.filter(out);
  return from_pcl(out);
}

}  // namespace emtr
