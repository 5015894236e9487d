#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include "geometry/cloud.h"

namespace emtr {

/// Converts to PCL's points. PCL's headers are large: only files that need them include this one.
inline pcl::PointCloud<pcl::PointXYZ>::Ptr to_pcl(const Cloud& cloud) {
  auto out = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  out->resize(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i)
    (*out)[i] = pcl::PointXYZ(cloud.x[i], cloud.y[i], cloud.z[i]);
  return out;
}

/// Converts from PCL's points.
inline Cloud from_pcl(const pcl::PointCloud<pcl::PointXYZ>& cloud) {
  Cloud out;
  out.resize(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    out.x[i] = cloud[i].x;
    out.y[i] = cloud[i].y;
    out.z[i] = cloud[i].z;
  }
  return out;
}

}  // namespace emtr
