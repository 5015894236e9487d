#include "read/cloud_file.h"

#include <chrono>
#include <exception>
#include <new>

#include "failure.h"
#include "mesh/sample_mesh.h"
#include "read/coordinates.h"
#include "read/open_cloud.h"

namespace cli {

CloudFile load_cloud(const std::string& path, std::size_t mesh_points, const std::string& format) {
  const auto start = std::chrono::steady_clock::now();
  CloudFile cloud = open_cloud(path, format);
  try {
    cloud.format->read(cloud);
    require_coordinates(cloud);
    sample_mesh(cloud, mesh_points);
  } catch (const std::bad_alloc&) {
    throw FileFailure(path, "not enough memory for its points");
  }
  cloud.sensor_known = !cloud.sensor_origin.isZero(0) ||
                       cloud.sensor_orientation.coeffs() != Eigen::Vector4d::UnitW();
  cloud.milliseconds =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return cloud;
}

}  // namespace cli
