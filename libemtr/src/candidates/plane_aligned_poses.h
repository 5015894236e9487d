#pragma once

#include <cstddef>
#include <vector>

#include "candidates/surface_pair.h"
#include "geometry/rigid.h"
#include "util/thread_team.h"

namespace emtr {

/// Returns poses that lay a dominant plane of the source on one of the target, as ground on ground:
/// what is left of the pose is a rotation about the plane's normal and a translation along it. For
/// each rotation, pairs of points that stand upright on the planes, at one height and facing the
/// same way, vote for their translation. Unlike matches of descriptors this needs nothing that is
/// locally distinct, so it finds streets, buildings and rooms seen from far apart. At most
/// `maximum_count`, those of most votes for each point first; not refined. Empty where one of the
/// clouds has no such plane.
std::vector<Rigid> plane_aligned_poses(const SurfacePair& surfaces, std::size_t maximum_count,
                                       const Kernels& kernels, ThreadTeam& team);

}  // namespace emtr
