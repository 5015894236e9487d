#pragma once

#include <string>

#include "read/cloud_file.h"

namespace cli {

/// Throws FileFailure when the format of `path` (.pcd or .ply) cannot hold one of the fields.
void require_writable_as(const std::string& path, const CloudFile& cloud);

/// Writes a binary PCD or PLY, by the extension of `path`, to the file `temporary`. Throws
/// FileFailure about `path` unless every byte arrived.
void write_cloud(const CloudFile& cloud, const std::string& path, const std::string& temporary);

}  // namespace cli
