#pragma once

#include <vector>

#include "batch/pair.h"
#include "batch/record_file.h"
#include "batch/status_line.h"
#include "options/options.h"

namespace cli {

/// Registers the pairs by several threads and appends their records as they are done. Returns when
/// all are done, or when a signal asked to stop. Throws FileFailure when a record cannot be
/// written.
void work_on(const std::vector<const Pair*>& pairs, const Options& options, RecordFile& records,
             StatusLine& status);

}  // namespace cli
