#pragma once

#include <emtr/emtr.h>

#include "report/json.h"

namespace cli {

/// Adds every field of a result under its group and key, in the order of the library's table of
/// result fields. "refinement" is null when the pose was not refined.
void add_result(Json& out, const emtr_result& result);

}  // namespace cli
