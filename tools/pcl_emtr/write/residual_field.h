#pragma once

#include <vector>

#include "read/cloud_file.h"

namespace cli {

/// Throws FileFailure when the cloud has a field `residual` that is not a single float.
void require_place_for_residuals(const CloudFile& cloud);

/// Writes one residual for each point into the float field `residual`, which is added if need be.
void set_residuals(CloudFile& cloud, const std::vector<double>& residuals);

}  // namespace cli
