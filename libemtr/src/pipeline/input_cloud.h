#pragma once

#include <emtr/emtr.h>

#include "preprocessing/normalization.h"
#include "settings/settings.h"

namespace emtr {

/// A cloud of the user's: in the user's memory, or preprocessed before.
struct InputCloud {
  const emtr_cloud* cloud = nullptr;  ///< read unless there is a preprocessed cloud
  PreprocessedCloudPtr preprocessed;  ///< null: receives what is made of `cloud`
};

/// Reads and preprocesses both clouds, the source first, unless that was done before.
void preprocess(InputCloud& source, InputCloud& target, const Settings& user);

/// Reads and normalizes both clouds, the source first. A cloud that is preprocessed stays available
/// when the run is stopped or fails after it. `user`: the settings with the user's correspondences.
NormalizedPair normalize(InputCloud& source, InputCloud& target, const Settings& user);

}  // namespace emtr
