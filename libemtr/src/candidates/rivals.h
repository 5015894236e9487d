#pragma once

#include <vector>

#include "candidates/surface_pair.h"
#include "geometry/rigid.h"

namespace emtr {

/// Returns the poses that a scene which looks alike from several sides would fit as well: `best`,
/// rotated by 90, 180 and 270 degrees about the principal axes of both clouds laid together and
/// about the normal that most of them share, through their centroid and through the middle of their
/// box. Not refined, and no two of them the same.
std::vector<Rigid> rotated_rivals(const SurfacePair& surfaces, const Rigid& best);

}  // namespace emtr
