#include "read/pcl_readers.h"

#include <exception>
#include <new>

#include "failure.h"
#include "modules/pcl_module.h"
#include "read/format_check.h"
#include "read/pcd_viewpoint.h"
#include "read/ply_body.h"
#include "read/ply_camera.h"
#include "read/ply_faces.h"

namespace cli {
namespace {

using Reader = decltype(PclModule::read_pcd);

void read(CloudFile& cloud, Reader reader, std::uint64_t points) {
  int status = -1;
  try {
    status = reader(cloud.place, cloud.blob);
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
  const std::uint64_t points = check_pcd(cloud.place, cloud.path);
  read(cloud, pcl_module().read_pcd, points);
  read_pcd_viewpoint(cloud);
}

void read_ply(CloudFile& cloud) {
  const std::uint64_t points = check_ply(cloud.place, cloud.path);
  if (!read_ply_body(cloud)) read(cloud, pcl_module().read_ply, points);
  read_ply_camera(cloud);
  read_ply_faces(cloud);
}

}  // namespace cli
