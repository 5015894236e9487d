#pragma once

#include <emtr/emtr.h>

#include <memory>

#include "cloud_file.h"
#include "command_line.h"

namespace cli {

struct FreeResult {
  void operator()(emtr_result* result) const { emtr_result_free(result); }
};
using Result = std::unique_ptr<emtr_result, FreeResult>;

/// Runs the registration with progress line and interrupts. Never null; the pose is finite.
/// Throws a Failure that names the file at fault.
Result run_registration(const CloudFile& source, const CloudFile& target, const Options& options);

/// What the process returns for a result.
int exit_code(const emtr_result& result);

}  // namespace cli
