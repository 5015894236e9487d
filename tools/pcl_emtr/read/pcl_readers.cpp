#include "read/pcl_readers.h"

#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>

#include <exception>
#include <new>

#include "failure.h"
#include "read/format_check.h"
#include "read/pcd_viewpoint.h"
#include "read/ply_camera.h"
#include "read/ply_faces.h"

namespace cli {
namespace {

/// Reads all but the sensor's pose: PCL's is short of digits, and its versions differ in what they
/// take for one.
template <class Reader>
void read(CloudFile& cloud, std::uint64_t points) {
  Eigen::Vector4f origin;
  Eigen::Quaternionf orientation;
  int version = 0;
  int status = -1;
  try {
    status = Reader().read(cloud.place, cloud.blob, origin, orientation, version);
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
}

}  // namespace

void read_pcd(CloudFile& cloud) {
  read<pcl::PCDReader>(cloud, check_pcd(cloud.place, cloud.path));
  read_pcd_viewpoint(cloud);
}

void read_ply(CloudFile& cloud) {
  read<pcl::PLYReader>(cloud, check_ply(cloud.place, cloud.path));
  read_ply_camera(cloud);
  read_ply_faces(cloud);
}

}  // namespace cli
