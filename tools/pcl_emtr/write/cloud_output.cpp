#include "write/cloud_output.h"

#include "failure.h"
#include "modules/pcl_module.h"
#include "write/obj_output.h"
#include "write/pcd_output.h"
#include "write/ply_output.h"

namespace cli {
namespace {

bool write_as(const std::string& extension, const CloudFile& cloud, const std::string& temporary) {
  if (extension == ".ply") return write_ply(cloud, temporary);
  if (extension == ".obj") return write_obj(cloud, temporary);
  return write_pcd(cloud, temporary);
}

}  // namespace

void require_writable_as(const std::string& path, const Format& format, const CloudFile& cloud) {
  const std::string extension = format.extension;
  if (extension == ".ply") require_ply_fields(cloud, path);
  if (extension == ".obj") return require_obj_fields(cloud, path);
  pcl_module();  // which may fail, so before the long computation
}

void write_cloud(const CloudFile& cloud, const Format& format, const std::string& path,
                 const std::string& temporary) {
  if (!write_as(format.extension, cloud, temporary))
    throw FileFailure(path, "cannot be written whole, is the disk full?");
}

}  // namespace cli
