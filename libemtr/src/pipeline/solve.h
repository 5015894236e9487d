#pragma once

#include <memory>
#include <vector>

#include "pipeline/problem.h"
#include "pipeline/result.h"
#include "pipeline/solution.h"
#include "util/cancellation.h"

namespace emtr {

/// Searches the pose of a problem up to its ranked candidates, by one search: without refinement,
/// and without a verdict. Throws Cancelled when the token stops it.
Solution search_candidates(const Problem& problem, CancellationToken& token);

/// Searches the pose of a problem and judges it, as solve() does.
Solution search_pose(const Problem& problem, CancellationToken& token,
                     const std::vector<Rigid>* poses = nullptr);

/// Searches the pose of a problem by one search. Where that leaves it in doubt, the pose is
/// neither refined nor judged.
Solution search_once(const Problem& problem, CancellationToken& token);

/// Returns the result of a search that ended, or that the token stopped.
std::unique_ptr<Result> conclude(const Problem& problem, const Solution& found,
                                 const CancellationToken& token);

/// Searches the pose of a problem and judges it. Does not change the problem, so it can be solved
/// again. The token may stop it; the result is then the best pose so far. `poses`: known ones,
/// normalized frame, in the place of an evolution; null to evolve.
std::unique_ptr<Result> solve(const Problem& problem, CancellationToken& token,
                              const std::vector<Rigid>* poses = nullptr);

}  // namespace emtr
