#include "write/cloud_output.h"

#include "failure.h"
#include "read/cloud_path.h"
#include "write/pcd_output.h"
#include "write/ply_output.h"

namespace cli {

void require_writable_as(const std::string& path, const CloudFile& cloud) {
  if (extension_of(path) == ".ply") require_ply_fields(cloud, path);
}

void write_cloud(const CloudFile& cloud, const std::string& path, const std::string& temporary) {
  const bool whole =
      extension_of(path) == ".ply" ? write_ply(cloud, temporary) : write_pcd(cloud, temporary);
  if (!whole) throw FileFailure(path, "cannot be written whole, is the disk full?");
}

}  // namespace cli
