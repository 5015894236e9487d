#include "modules/pcl_module.h"

#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>

namespace {

using Blob = pcl::PCLPointCloud2;

/// The sensor's pose is dropped: PCL's is short of digits, and its versions differ in what they
/// take for one.
template <class Reader>
int read(const std::string& path, Blob& cloud) {
  Eigen::Vector4f origin;
  Eigen::Quaternionf orientation;
  int version = 0;
  return Reader().read(path, cloud, origin, orientation, version);
}

std::string pcd_header(const Blob& cloud, const Eigen::Vector4f& origin,
                       const Eigen::Quaternionf& orientation) {
  return pcl::PCDWriter().generateHeaderBinary(cloud, origin, orientation);
}

std::string ply_header(const Blob& cloud, const Eigen::Vector4f& origin,
                       const Eigen::Quaternionf& orientation) {
  const auto points = static_cast<int>(cloud.width * cloud.height);
  return pcl::PLYWriter().generateHeaderBinary(cloud, origin, orientation, points, true);
}

int write_ply(const std::string& path, const Blob& cloud, const Eigen::Vector4f& origin,
              const Eigen::Quaternionf& orientation) {
  return pcl::PLYWriter().writeBinary(path, cloud, origin, orientation, true);
}

}  // namespace

const cli::PclModule emtr_pcl_module_1 = {read<pcl::PCDReader>, read<pcl::PLYReader>, pcd_header,
                                          ply_header, write_ply};
