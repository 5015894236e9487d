#pragma once

#include <vector>

#include "preprocessing/normalization.h"
#include "kernels/kernels.h"
#include "ranking/viewpoint.h"
#include "geometry/rigid.h"
#include "settings/settings.h"

namespace emtr {

/// Poses for pairs that the first search left in doubt, mostly those of little overlap: many more
/// feature points, normals turned to the sensors instead of the centroids (which differ when little
/// is shared), both signs of the normals where the sensors are guesses, and matches that are among
/// the three nearest of each other. Seeds of consistent matches, the best supported first.
std::vector<Rigid> fallback_seeds_of(const NormalizedPair& pair, const Viewpoints& of_source,
                                   const Viewpoints& of_target, const Settings& settings,
                                   const Kernels& kernels, int threads);

}  // namespace emtr
