#pragma once

#include "preprocessing/normalization.h"
#include "priors/prior.h"
#include "settings/settings.h"

namespace emtr {

/// Returns the set of poses that the settings admit, null when they admit all. Throws Error, naming
/// the settings, when no admissible pose can be found.
PriorPtr make_prior(const Settings& settings, const Normalization& normalization);

/// Returns the user's guess in the normalized frame. Throws Error when it moves the source farther
/// than floats can tell.
Rigid normalized_guess(const Settings& settings, const Normalization& normalization);

}  // namespace emtr
