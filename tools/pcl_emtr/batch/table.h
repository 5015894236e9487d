#pragma once

#include "batch/record_file.h"

namespace cli {

/// Writes DIR/results.csv, a line a pair, whole or not at all. Throws FileFailure.
void write_table(const RecordFile& records);

}  // namespace cli
