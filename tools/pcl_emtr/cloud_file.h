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
  bool sensor_known = false;  // the file has a pose other than the one that all files begin with
  std::string note;           // what was left out of the file, or empty
  double milliseconds = 0;

  std::size_t size() const { return std::size_t{blob.width} * blob.height; }
};

/// ".pcd" for "a/B.PCD", "" when there is none.
std::string extension_of(const std::string& path);

/// An existing, readable regular file with extension .pcd, .ply or .obj; throws FileFailure.
void require_cloud_file(const std::string& path);

/// Reads PCD, PLY or OBJ by extension; throws FileFailure on whatever is wrong with it.
CloudFile load_cloud(const std::string& path);

}  // namespace cli
