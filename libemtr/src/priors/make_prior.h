#pragma once

#include "preprocessing/normalization.h"
#include "settings/settings.h"
#include "priors/prior.h"

namespace emtr {

/// Throws Error for a setting that no cloud could go with: no finite direction or corner, limits
/// that are crossed, a limit without what it is about.
void validate_priors(const Settings& settings);

/// The set of poses that the settings admit; null when that is all of them. Throws Error, naming
/// the settings, when it is empty as far as can be told: no pose was found in it.
PriorPtr make_prior(const Settings& settings, const Normalization& normalization);

/// The caller's guess in the normalized frame. Throws Error when it is out of sight.
Rigid normalized_guess(const Settings& settings, const Normalization& normalization);

}  // namespace emtr
