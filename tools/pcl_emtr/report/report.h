#pragma once

#include <emtr/emtr.h>

#include <string>
#include <vector>

#include "options/options.h"
#include "read/cloud_file.h"
#include "report/json.h"
#include "report/unit_hint.h"

namespace cli {

/// Returns everything about a run as JSON: enough to repeat it and to judge it. What is not known
/// is null: the rmse without inliers, the confidence without candidates, files not asked for.
/// Lengths are in the clouds' own unit, leaves in the normalized frame, times in seconds.
/// `residuals` come from measure_residuals() and are empty unless the user asked for them.
Json report(const Options& options, const CloudFile& source, const CloudFile& target,
            const emtr_result& result, const std::vector<double>& residuals, const UnitHint& hint);

/// Returns the report as the text of its file.
std::string report_text(const Json& report);

}  // namespace cli
