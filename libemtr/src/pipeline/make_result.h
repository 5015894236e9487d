#pragma once

#include <memory>

#include "pipeline/problem.h"
#include "pipeline/result.h"
#include "pipeline/solution.h"

namespace emtr {

/// Writes a pose with its score, in the user's unit.
void write_alternative(const Problem& problem, const Candidate& candidate, emtr_alternative& out);

/// Writes a problem and its solution into a result, in the user's unit. Unknown values are NaN.
std::unique_ptr<Result> make_result(const Problem& problem, const Solution& found);

}  // namespace emtr
