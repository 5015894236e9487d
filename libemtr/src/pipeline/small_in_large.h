#pragma once

#include <memory>

#include "pipeline/input_cloud.h"
#include "pipeline/result.h"
#include "settings/settings.h"
#include "util/cancellation.h"

namespace emtr {

/// Tells whether one cloud is so much smaller than the other that no leaf serves both, and the
/// settings let it be looked for: an object in a scene.
bool is_small_in_large(const PreprocessedCloud& source, const PreprocessedCloud& target,
                       const Settings& settings);

/// Registers the smaller cloud with the parts of the larger where it may lie: a part is as large as
/// the smaller cloud, and has its own leaf, search and verdict. Returns the result of the best
/// part, in which the other parts' poses are rivals; null when there is no place that is worth a
/// look. The larger cloud is read again, so that it may be finer than its base points.
std::unique_ptr<Result> register_small_in_large(const InputCloud& source, const InputCloud& target,
                                                const Settings& settings, CancellationToken& token);

}  // namespace emtr
