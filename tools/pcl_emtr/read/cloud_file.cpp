#include "read/cloud_file.h"

#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>

#include <chrono>
#include <new>

#include "failure.h"
#include "read/cloud_path.h"
#include "read/coordinates.h"
#include "read/format_check.h"
#include "read/obj_reader.h"
#include "read/pcd_viewpoint.h"
#include "read/ply_camera.h"

namespace cli {
namespace {

template <class Reader>
void read(CloudFile& cloud, std::uint64_t points) {
  Eigen::Vector4f origin = Eigen::Vector4f::Zero();
  Eigen::Quaternionf orientation = Eigen::Quaternionf::Identity();
  int version = 0;
  int status = -1;
  try {
    status = Reader().read(cloud.path, cloud.blob, origin, orientation, version);
  } catch (const std::bad_alloc&) {
    throw FileFailure(cloud.path,
                      "not enough memory for its " + std::to_string(points) + " points");
  } catch (const std::exception& error) {
    throw FileFailure(cloud.path, std::string("cannot be read: ") + error.what());
  }
  if (status < 0)
    throw FileFailure(cloud.path, "cannot be read: truncated, damaged, or of an unusual form");
  // PCL sorts the vertices of a PLY file into its range grid, whatever size that has.
  if (cloud.size() == 0 || cloud.blob.data.size() != cloud.size() * cloud.blob.point_step)
    throw FileFailure(cloud.path, "cannot be read: its points are not as many as it declares");
  cloud.sensor_origin = origin.head<3>().cast<double>();
  cloud.sensor_orientation = orientation.cast<double>();
}

}  // namespace

CloudFile load_cloud(const std::string& path) {
  const auto start = std::chrono::steady_clock::now();
  require_cloud_file(path);
  CloudFile cloud;
  cloud.path = path;
  const std::string extension = extension_of(path);
  if (extension == ".pcd") {
    read<pcl::PCDReader>(cloud, check_pcd(path));
    read_pcd_viewpoint(cloud);
  } else if (extension == ".ply") {
    read<pcl::PLYReader>(cloud, check_ply(path));
    read_ply_camera(cloud);
  } else {
    cloud.note = read_obj(path, cloud.blob);
  }
  require_coordinates(cloud);
  cloud.sensor_known = !cloud.sensor_origin.isZero(0) ||
                       cloud.sensor_orientation.coeffs() != Eigen::Vector4d::UnitW();
  cloud.milliseconds =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return cloud;
}

}  // namespace cli
