#pragma once

#include <memory>

#include "pipeline/problem.h"
#include "pipeline/result.h"
#include "util/cancellation.h"

namespace emtr {

/// Searches the pose of a problem and judges it. Does not change the problem, so it can be solved
/// again. The token may stop it; the result is then the best pose so far.
std::unique_ptr<Result> solve(const Problem& problem, CancellationToken& token);

}  // namespace emtr
