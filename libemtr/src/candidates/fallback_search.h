#pragma once

#include <optional>
#include <vector>

#include "correspondences/correspondence.h"
#include "geometry/cloud.h"
#include "geometry/rigid.h"
#include "kernels/kernels.h"
#include "preprocessing/normalization.h"
#include "ranking/viewpoint.h"
#include "settings/settings.h"

namespace emtr {

/// Finds poses for pairs that the first search left in doubt, mostly those of little overlap, by
/// many more keypoints, normals oriented to the sensors instead of the centroids (which differ when
/// little is shared), both signs of the normals where the sensors are estimates, and matches that
/// are among the three nearest of each other. Seeds of consistent matches, the best supported
/// first.
std::vector<Rigid> find_fallback_seeds(const NormalizedPair& pair,
                                       const std::optional<Viewpoint>& source_viewpoint,
                                       const std::optional<Viewpoint>& target_viewpoint,
                                       const Settings& settings, const Kernels& kernels,
                                       int threads);

/// Returns the poses that consistent matches agree on, at most `fallback_seeds`, those with the
/// most inliers first. `leaf`: of both clouds, normalized frame.
std::vector<Rigid> poses_of_matches(const Cloud& source, const Cloud& target,
                                    const std::vector<Correspondence>& matches, double leaf,
                                    const Settings& settings, const Kernels& kernels, int threads);

}  // namespace emtr
