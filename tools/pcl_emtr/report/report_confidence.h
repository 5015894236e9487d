#pragma once

#include <emtr/emtr.h>

#include "report/json.h"

namespace cli {

// The parts of the report that tell how far the result can be trusted.

/// Adds the verdict, its reason, the confidence and the transformation.
void add_verdict(Json& out, const emtr_result& result);

/// Returns how well the clouds fit; values that are not known are null.
Json quality_json(const emtr_result& result);

/// Returns the other poses that the clouds could be in, best first; empty when none is known.
Json alternatives_json(const emtr_result& result);

/// Returns the information matrix and how firmly the surfaces constrain the pose; null when the
/// pose was not refined.
Json refinement_json(const emtr_result& result);

}  // namespace cli
