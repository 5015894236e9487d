#pragma once

#include <emtr/emtr.h>

#include <array>
#include <vector>

#include "options/options.h"
#include "read/cloud_file.h"
#include "report/json.h"

namespace cli {

/// Returns for the pose of the result and for each alternative the largest distance of these points
/// of the source to the target, and all distances as shares of it. Throws Failure.
Json pose_residuals(const std::vector<std::array<double, 3>>& points, const CloudFile& target,
                    const Options& options, const emtr_result& result);

}  // namespace cli
