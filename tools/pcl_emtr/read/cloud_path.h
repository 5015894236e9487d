#pragma once

#include <string>

namespace cli {

/// Returns the extension in lower case: ".pcd" for "a/B.PCD", "" when there is none.
std::string extension_of(const std::string& path);

/// Tells whether the path is named like a cloud: .pcd, .ply or .obj.
bool names_cloud(const std::string& path);

/// Throws FileFailure unless the path is a readable regular file named like a cloud.
void require_cloud_file(const std::string& path);

}  // namespace cli
