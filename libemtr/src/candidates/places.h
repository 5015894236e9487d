#pragma once

#include <vector>

#include "geometry/cloud.h"
#include "geometry/rigid.h"
#include "settings/settings.h"

namespace emtr {

/// Finds where a small cloud may lie in a much larger one: an object in a scene. Both clouds are in
/// one frame, whose unit is the radius of the larger; the small one is about its own centroid.
/// Descriptors are those of the small cloud's size, so the large one is described as finely.
/// Returns poses of the small cloud in the large one that consistent matches agree on, those with
/// the most matches first; none when the large cloud is too coarse to show the small one.
std::vector<Rigid> find_places(const Cloud& small, const Cloud& large, const Settings& settings,
                               const Kernels& kernels);

}  // namespace emtr
