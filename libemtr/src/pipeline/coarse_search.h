#pragma once

#include <memory>

#include "pipeline/input_cloud.h"
#include "pipeline/result.h"
#include "pipeline/stage_seconds.h"
#include "util/cancellation.h"

namespace emtr {

/// Registers both clouds: by `coarse_points` and a smaller swarm, without a second search, which
/// most pairs do not need; and where that leaves doubt, as the settings say. The first part is left
/// out where the settings do not ask for it, or where so few points leave too few of one cloud. A
/// run that is stopped before the finer search has a pose gives the coarse one's. `seconds`: what
/// the run has taken before.
std::unique_ptr<Result> register_coarse_to_fine(InputCloud& source, InputCloud& target,
                                                const Settings& settings, CancellationToken& token,
                                                const StageSeconds& seconds);

}  // namespace emtr
