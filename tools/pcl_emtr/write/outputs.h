#pragma once

#include <emtr/emtr.h>

#include <vector>

#include "options/options.h"
#include "read/cloud_file.h"
#include "report/unit_hint.h"

namespace cli {

/// Writes the matrix, and the report and the moved source if the user asked for them: all of them
/// or none. Moves `source`. Throws Failure.
void write_outputs(const Options& options, CloudFile& source, const CloudFile& target,
                   const emtr_result& result, const std::vector<double>& residuals,
                   const UnitHint& hint);

}  // namespace cli
