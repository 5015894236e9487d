#pragma once

#include <memory>

#include "pipeline/input_cloud.h"
#include "pipeline/result.h"
#include "settings/settings.h"
#include "util/cancellation.h"

namespace emtr {

/// Registers two clouds: a problem and its solution. A cloud that is much smaller than the other is
/// looked for in its parts first. Throws Error on bad clouds or settings. The token may stop it.
std::unique_ptr<Result> register_clouds(InputCloud& source, InputCloud& target,
                                        const Settings& settings, CancellationToken& token);

}  // namespace emtr
