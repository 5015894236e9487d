#pragma once

#include <memory>

#include "pipeline/input_cloud.h"
#include "pipeline/result.h"
#include "settings/settings.h"
#include "util/cancellation.h"

namespace emtr {

/// How the sizes of two clouds compare. If they are different, one leaf serves both badly, and the
/// smaller cloud may lie in a part of the larger; if they are very different, as an object's and a
/// scene's are, it serves them hardly ever.
enum class Sizes { Alike, Different, VeryDifferent };

/// Compares the radii. Sizes are alike too where the settings do not let the parts be searched.
Sizes compare_sizes(const PreprocessedCloud& source, const PreprocessedCloud& target,
                    const Settings& settings);

/// Registers the smaller cloud with the parts of the larger where it may lie: a part is as large as
/// the smaller cloud, and has its own leaf, search and verdict. Returns the result of the best
/// part, in which the other parts' poses are rivals; null when there is no place that is worth a
/// look. The larger cloud is read again, so that it may be finer than its base points.
std::unique_ptr<Result> register_small_in_large(const InputCloud& source, const InputCloud& target,
                                                const Settings& settings, CancellationToken& token);

}  // namespace emtr
