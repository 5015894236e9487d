#pragma once

#include <vector>

#include "read/cloud_file.h"

namespace cli {

/// Throws Failure when the format has no fields of any name, or the cloud a field `residual` that
/// is not a single float.
void require_place_for_residuals(const CloudFile& cloud, const Format& format);

/// Writes one residual for each point into the float field `residual`, which is added if need be.
void set_residuals(CloudFile& cloud, const std::vector<double>& residuals);

}  // namespace cli
