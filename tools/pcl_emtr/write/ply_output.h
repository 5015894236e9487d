#pragma once

#include <string>

#include "read/cloud_file.h"

namespace cli {

/// Throws FileFailure about `path` when PLY, as PCL writes it, cannot hold one of the fields.
void require_ply_fields(const CloudFile& cloud, const std::string& path);

/// Writes a binary PLY file, with the faces of a mesh; returns false unless every byte arrived.
bool write_ply(const CloudFile& cloud, const std::string& path);

}  // namespace cli
