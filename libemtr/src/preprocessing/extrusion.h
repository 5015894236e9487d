#pragma once

#include "preprocessing/normalization.h"
#include "settings/settings.h"

namespace emtr {

/// Makes walls of the outlines of a two-dimensional pair, which has no surface: clouds that are
/// flat across the axis of the user's prior are repeated in layers along it. Changes no other pair,
/// and none with the user's normals.
void extrude_flat_pair(NormalizedPair& pair, const Settings& settings);

}  // namespace emtr
