#pragma once

#include <emtr/emtr.h>

#include "read/cloud_file.h"
#include "report/json.h"

namespace cli {

/// Adds what the run counted, queried and took: counts, nearest-neighbor queries, the normalization
/// of the clouds, seconds, and the best fitness of each iteration.
void add_costs(Json& out, const CloudFile& source, const CloudFile& target,
               const emtr_result& result);

}  // namespace cli
