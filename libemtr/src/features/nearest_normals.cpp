#include "features/nearest_normals.h"

#include <pcl/features/normal_3d.h>
#include <pcl/search/kdtree.h>

#include "geometry/pcl_cloud.h"

namespace emtr {

Cloud nearest_normals(const Cloud& cloud, int count) {
  pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud(to_pcl(cloud));
  estimation.setSearchMethod(pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>());
  estimation.setKSearch(count);
  pcl::PointCloud<pcl::Normal> normals;
  estimation.compute(normals);
  Cloud out;
  for (const pcl::Normal& n : normals) out.append(n.normal_x, n.normal_y, n.normal_z);
  return out;
}

}  // namespace emtr
