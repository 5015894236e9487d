#pragma once

#include <string>

#include "read/cloud_file.h"

namespace cli {

/// Finds out where the bytes of a cloud are and what format they have. Reads a stream to its end,
/// and unpacks what gzip has compressed. `format` is the one that the user named, or empty: then
/// the extension counts, and for a stream without one its beginning. Throws FileFailure.
CloudFile open_cloud(const std::string& path, const std::string& format = "");

}  // namespace cli
