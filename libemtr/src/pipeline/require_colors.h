#pragma once

#include "preprocessing/preprocessed_cloud.h"
#include "settings/settings.h"

namespace emtr {

/// Throws Error, naming the cloud, where the settings insist on colors that the clouds do not have.
void require_colors(const Settings& settings, const PreprocessedCloud& source,
                    const PreprocessedCloud& target);

}  // namespace emtr
