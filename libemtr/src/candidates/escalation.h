#pragma once

#include <vector>

#include "../frame/frame.h"
#include "../kernels/kernels.h"
#include "../ranking/viewpoint.h"
#include "../rigid.h"
#include "../settings.h"

namespace emtr {

/// Poses for pairs that the first search left in doubt, mostly those of little overlap: many more
/// feature points, normals turned to the sensors instead of the centroids (which differ when little
/// is shared), both signs of the normals where the sensors are guesses, and matches that are among
/// the three nearest of each other. Seeds of consistent matches, the best supported first.
std::vector<Rigid> escalated_seeds(const NormalisedPair& pair, const Viewpoints& of_source,
                                   const Viewpoints& of_target, const Settings& settings,
                                   const Kernels& kernels, int threads);

}  // namespace emtr
