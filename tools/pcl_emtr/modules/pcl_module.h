#pragma once

#include <pcl/PCLPointCloud2.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>

namespace cli {

/// What the command calls of libpcl_io. Sixty libraries come with that one, so a module of the
/// command links it, which is loaded when a file needs it. Each function may throw what PCL throws.
struct PclModule {
  using Blob = pcl::PCLPointCloud2;

  // Read a file but for the sensor's pose; return PCL's status, which is below 0 when it fails.
  int (*read_pcd)(const std::string& path, Blob& cloud);
  int (*read_ply)(const std::string& path, Blob& cloud);

  /// Returns the header of a binary PCD file up to its line DATA.
  std::string (*pcd_header)(const Blob& cloud, const Eigen::Vector4f& origin,
                            const Eigen::Quaternionf& orientation);

  // The header of a binary PLY file with an element "camera", and the whole file; the second
  // returns 0 when it is written.
  std::string (*ply_header)(const Blob& cloud, const Eigen::Vector4f& origin,
                            const Eigen::Quaternionf& orientation);
  int (*write_ply)(const std::string& path, const Blob& cloud, const Eigen::Vector4f& origin,
                   const Eigen::Quaternionf& orientation);
};

/// Returns the module, loaded at the first call; throws Failure when it is missing.
const PclModule& pcl_module();

}  // namespace cli

/// The module's one symbol; its number changes with the struct.
extern "C" const cli::PclModule emtr_pcl_module_1;
