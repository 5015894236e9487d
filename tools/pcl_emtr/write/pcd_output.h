#pragma once

#include <string>

#include "read/cloud_file.h"

namespace cli {

/// Writes a binary PCD file; returns false unless every byte arrived. PCL makes the header only,
/// because its writer does not report a full disk.
bool write_pcd(const CloudFile& cloud, const std::string& path);

}  // namespace cli
