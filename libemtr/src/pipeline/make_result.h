#pragma once

#include <memory>

#include "pipeline/problem.h"
#include "pipeline/result.h"
#include "pipeline/solution.h"

namespace emtr {

/// Writes what is known of a problem and of its solution into a result, in the user's unit. What
/// is not known is NaN.
std::unique_ptr<Result> make_result(const Problem& problem, const Solution& found);

}  // namespace emtr
