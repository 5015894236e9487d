#pragma once

#include <emtr/emtr.h>

#include <memory>

#include "options/options.h"
#include "read/cloud_file.h"

namespace cli {

struct FreeResult {
  void operator()(emtr_result* result) const { emtr_result_free(result); }
};
using Result = std::unique_ptr<emtr_result, FreeResult>;

/// Registers the clouds, with a progress line and until a signal asks to stop. The result is never
/// null and its pose is finite. Throws a Failure that names the file at fault, and says so when the
/// clouds seem to be in different units.
Result run_registration(const CloudFile& source, const CloudFile& target, const Options& options);

/// Returns the exit code of the process for a result.
int exit_code(const emtr_result& result);

}  // namespace cli
