#pragma once

#include <cstddef>
#include <vector>

#include "candidates/surface_pair.h"
#include "geometry/rigid.h"
#include "util/thread_team.h"

namespace emtr {

/// Returns the poses that a scene which looks alike from several sides would fit as well: `best`,
/// rotated by 90, 180 and 270 degrees about the principal axes of both clouds laid together and
/// about the normal that most of them share, through their centroid and through the middle of their
/// box. Not refined, and no two of them the same.
std::vector<Rigid> quarter_rotated_rivals(const SurfacePair& surfaces, const Rigid& best);

/// Returns the poses that an object with other symmetries would fit nearly as well, as one of three
/// or five folds: `best`, rotated about the same axes to where a few points fit best. At most
/// kMostPeaks, the best first; not refined.
std::vector<Rigid> rotated_rivals(const SurfacePair& surfaces, const Rigid& best, ThreadTeam& team);

/// Returns the poses that a scene with a period would fit nearly as well: `best`, moved along the
/// same axes to where a few points fit best, up to kFarthestTranslation either way. At most
/// kMostPeaks, the best first; not refined.
std::vector<Rigid> translated_rivals(const SurfacePair& surfaces, const Rigid& best,
                                     ThreadTeam& team);

constexpr double kFarthestTranslation = 1.2;  ///< radii
constexpr std::size_t kMostPeaks = 6;

}  // namespace emtr
