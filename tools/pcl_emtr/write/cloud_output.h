#pragma once

#include <string>

#include "read/cloud_file.h"

namespace cli {

/// Throws FileFailure about `path` when the format cannot hold one of the fields of the cloud, or
/// of the vertices of a mesh whose faces it keeps; Failure when its writer cannot be loaded.
void require_writable_as(const std::string& path, const Format& format, const CloudFile& cloud);

/// Writes a binary PCD, a binary PLY or an OBJ to the file `temporary`. Throws FileFailure about
/// `path` unless every byte arrived.
void write_cloud(const CloudFile& cloud, const Format& format, const std::string& path,
                 const std::string& temporary);

}  // namespace cli
