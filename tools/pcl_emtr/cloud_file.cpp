#include "cloud_file.h"

#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <new>

#include "coordinates.h"
#include "failure.h"
#include "format_check.h"
#include "obj_reader.h"
#include "pcd_header.h"
#include "ply_camera.h"

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
  // PCL sorts the vertices of a PLY file into its range grid, whatever its size.
  if (cloud.size() == 0 || cloud.blob.data.size() != cloud.size() * cloud.blob.point_step)
    throw FileFailure(cloud.path, "cannot be read: its points are not as many as it declares");
  cloud.sensor_origin = origin.head<3>().cast<double>();
  cloud.sensor_orientation = orientation.cast<double>();
}

/// PCL holds it in floats, which are too short for map coordinates.
void read_pcd_viewpoint(CloudFile& cloud) {
  std::ifstream in(cloud.path, std::ios::binary);
  const auto viewpoint = PcdHeader(in, cloud.path).viewpoint();
  if (!viewpoint) return;
  const auto& v = *viewpoint;
  if (std::all_of(v.begin(), v.end(), [](double value) { return std::isfinite(value); })) {
    cloud.sensor_origin = {v[0], v[1], v[2]};
    cloud.sensor_orientation = Eigen::Quaterniond(v[3], v[4], v[5], v[6]);
  } else {
    cloud.sensor_origin.setZero();
    cloud.sensor_orientation.setIdentity();
    cloud.note = "its VIEWPOINT is left out, it is not finite";
  }
}

}  // namespace

std::string extension_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

void require_cloud_file(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found)
    throw FileFailure(path, "no such file");
  if (error) throw FileFailure(path, error.message());
  if (std::filesystem::is_directory(status))
    throw FileFailure(path, "is a directory, expected a .pcd, .ply or .obj file");
  if (!std::filesystem::is_regular_file(status))
    throw FileFailure(path, "is not a regular file, expected a .pcd, .ply or .obj file");
  const std::string extension = extension_of(path);
  if (extension != ".pcd" && extension != ".ply" && extension != ".obj")
    throw FileFailure(
        path, (extension.empty() ? "has no extension" : "unknown extension '" + extension + "'") +
                  ", expected .pcd, .ply or .obj");
  if (access(path.c_str(), R_OK) != 0) throw FileFailure(path, std::strerror(errno));
  if (std::filesystem::file_size(path) == 0) throw FileFailure(path, "is empty");
}

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
