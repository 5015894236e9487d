#pragma once

#include <emtr/emtr.h>

#include <vector>

#include "cloud_file.h"
#include "command_line.h"
#include "json_rows.h"

namespace cli {

/// How far each point of the source is from the nearest target point, once moved: in their unit,
/// NaN for points that are not finite. Throws Failure.
std::vector<double> measure_residuals(const CloudFile& source, const CloudFile& target,
                                      const Options& options, const emtr_result& result);

/// Throws FileFailure when the cloud has a field of that name that is no single float.
void require_place_for_residuals(const CloudFile& cloud);

/// Writes them into the float field `residual`, which is made unless it is there.
void set_residuals(CloudFile& cloud, const std::vector<double>& residuals);

/// Count, mean, root mean square, quantiles and maximum of those that are numbers.
Json residuals_json(std::vector<double> residuals);

}  // namespace cli
