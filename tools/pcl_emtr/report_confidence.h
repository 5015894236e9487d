#pragma once

#include <emtr/emtr.h>

#include "json_rows.h"

namespace cli {

// The parts of the report that tell how far the answer is to be trusted.

/// The other poses that the clouds could be in, best first; empty when none is known.
Json alternatives_json(const emtr_result& result);

/// Information matrix and how firmly the surfaces hold the pose; null when it was not refined.
Json refinement_json(const emtr_result& result);

}  // namespace cli
