#pragma once

#include <emtr/emtr.h>

#include <vector>

#include "read/cloud_file.h"

namespace cli {

/// Throws FileFailure unless the cloud has x, y and z, all float or all double.
void require_coordinates(const CloudFile& cloud);

/// Returns the coordinates as the C API takes them: a view of the cloud's own data where x, y and z
/// lie side by side, else of `copy`, which is filled. Valid as long as both live.
emtr_cloud coordinates(const CloudFile& cloud, std::vector<double>& copy);

}  // namespace cli
