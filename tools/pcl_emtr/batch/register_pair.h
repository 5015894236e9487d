#pragma once

#include <optional>

#include "batch/cloud_cache.h"
#include "batch/pair.h"
#include "batch/status_line.h"
#include "options/options.h"
#include "report/json.h"

namespace cli {

/// Registers a pair and returns its record: of the result, or of the fault that it has. Returns
/// nothing when a signal asked to stop.
std::optional<Json> register_pair(const Pair& pair, const Options& options, CloudCache& cache,
                                  StatusLine& status);

}  // namespace cli
