#pragma once

#include "geometry/surface.h"
#include "ranking/viewpoint.h"

namespace emtr {

/// Estimates where a scanner stood from how densely it sampled: a surface at range r, whose normal
/// makes the angle a with the ray, gets points in proportion to cos a / r^2. Of about 800 places
/// inside and around the cloud, the one is taken whose prediction correlates best with the points
/// in the voxels of the surface, and improved by steps along the axes. `cloud`: the points before
/// downsampling to the surface's leaf. `origin`: the origin of the user's coordinates, where most
/// scanners put themselves; it is tried too, and preferred where it does nearly as well.
///
/// The trust grows from 0 at a correlation of 0.05 to 1 at 0.3. Clouds that were fused from several
/// scans or sampled evenly stay below 0.2. It falls to 0 where a place outside of the cloud does no
/// better than the one on the other side.
Viewpoint estimate_sampling_viewpoint(const Surface& surface, const Cloud& cloud,
                                      const double origin[3], const Kernels& kernels);

}  // namespace emtr
