#pragma once

#include <emtr/emtr.h>

#include <string>
#include <vector>

#include "cloud_file.h"
#include "command_line.h"

namespace cli {

/// Everything about a run as JSON: enough to repeat it and to judge it. What is not known (the
/// rmse without inliers, the confidence without candidates, files not asked for) is null. Lengths
/// are in the clouds' own unit, leaves in the normalized frame, times in seconds.
/// `residuals`: see measure_residuals(), empty when they were not asked for.
std::string report(const Options& options, const CloudFile& source, const CloudFile& target,
                   const emtr_result& result, const std::vector<double>& residuals);

}  // namespace cli
