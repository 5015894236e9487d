#pragma once

#include <string>
#include <vector>

#include "options/file_names.h"

namespace cli {

/// Throws UsageFailure when two files are one stream: what it has can be read once, and what is
/// written to it would mix. `matrix_on_output` tells that standard output gets the matrix.
void check_streams(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs,
                   bool matrix_on_output);

}  // namespace cli
