#pragma once

#include <pcl/PCLPointCloud2.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>

namespace cli {

/// A cloud as its file has it: every field, and the pose of the sensor that took it.
struct CloudFile {
  std::string path;
  pcl::PCLPointCloud2 blob;
  Eigen::Vector3d sensor_origin = Eigen::Vector3d::Zero();
  Eigen::Quaterniond sensor_orientation = Eigen::Quaterniond::Identity();
  bool sensor_known = false;  // the file has a pose other than the default of its format
  std::string note;           // what was left out of the file, or empty
  double milliseconds = 0;    // spent on reading it

  std::size_t size() const { return std::size_t{blob.width} * blob.height; }
};

/// Reads PCD, PLY or OBJ by extension; throws FileFailure on whatever is wrong with the file.
CloudFile load_cloud(const std::string& path);

}  // namespace cli
