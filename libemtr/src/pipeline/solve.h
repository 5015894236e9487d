#pragma once

#include <memory>
#include <vector>

#include "pipeline/problem.h"
#include "pipeline/result.h"
#include "util/cancellation.h"

namespace emtr {

/// Searches the pose of a problem and judges it. Does not change the problem, so it can be solved
/// again. The token may stop it; the result is then the best pose so far. `poses`: known ones,
/// normalized frame, in the place of an evolution; null to evolve.
std::unique_ptr<Result> solve(const Problem& problem, CancellationToken& token,
                              const std::vector<Rigid>* poses = nullptr);

}  // namespace emtr
