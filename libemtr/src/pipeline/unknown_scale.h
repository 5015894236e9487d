#pragma once

#include <memory>

#include "pipeline/input_cloud.h"
#include "pipeline/result.h"
#include "pipeline/stage_seconds.h"
#include "settings/settings.h"
#include "util/cancellation.h"

namespace emtr {

/// Registers two clouds whose common scale is not known: searches the scale, then registers the
/// source at that scale as ever, and refines scale and pose together. The result's transformation
/// is a similarity. It is registered where the rigid run is, the surfaces fix the scale, and no
/// other similarity fits about as well. Both clouds are preprocessed; `seconds`: what that took.
std::unique_ptr<Result> register_unknown_scale(const InputCloud& source, const InputCloud& target,
                                               const Settings& settings, CancellationToken& token,
                                               const StageSeconds& seconds);

}  // namespace emtr
