#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "geometry/surface.h"

namespace emtr {

/// A plane on which many of a surface's points lie: ground, a floor, a wall, the top of a table.
struct DominantPlane {
  Eigen::Vector3d normal;  ///< unit length, towards the side on which more of the cloud lies
  double offset;           ///< normal * p of its points
  double share;            ///< of the cloud's points, (0, 1]
};

/// A plane of fewer points says little about where the cloud lies.
constexpr double kLeastPlane = 0.1;  ///< share

/// Returns at most `maximum_count` planes, those of the commonest directions first. Parallel ones
/// are at least 0.03 radii apart.
std::vector<DominantPlane> dominant_planes(const Surface& surface, std::size_t maximum_count);

}  // namespace emtr
