#pragma once

#include <memory>

#include "pipeline/input_cloud.h"
#include "pipeline/result.h"
#include "pipeline/stage_seconds.h"
#include "util/cancellation.h"

namespace emtr {

/// What a search by few points found.
struct CoarseSearch {
  std::unique_ptr<Result> result;  ///< null where there was no such search
  bool is_decided = false;         ///< the result leaves no doubt, or the run was stopped
  StageSeconds seconds;            ///< what the run has taken by now

  /// Returns the result of the search by all points, or, where that was stopped before it had a
  /// pose, this one's pose with the reason of the stop.
  std::unique_ptr<Result> unless_stopped(std::unique_ptr<Result> finer);
};

/// Registers both clouds by `coarse_points` and a smaller swarm, without a second search. Most
/// pairs need no more. Nothing is searched where the settings do not ask for it, or where so few
/// points leave too few of one cloud. `seconds`: what the run has taken before.
CoarseSearch search_coarsely(InputCloud& source, InputCloud& target, const Settings& settings,
                             CancellationToken& token, const StageSeconds& seconds);

}  // namespace emtr
