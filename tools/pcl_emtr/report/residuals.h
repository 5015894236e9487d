#pragma once

#include <emtr/emtr.h>

#include <vector>

#include "options/options.h"
#include "read/cloud_file.h"
#include "report/json.h"

namespace cli {

/// Returns the distance of each moved source point to the nearest target point, in the clouds'
/// unit; NaN for points that are not finite. Throws Failure.
std::vector<double> measure_residuals(const CloudFile& source, const CloudFile& target,
                                      const Options& options, const emtr_result& result);

/// Returns count, mean, root mean square, quantiles and maximum of the residuals that are numbers.
Json residuals_json(std::vector<double> residuals);

}  // namespace cli
