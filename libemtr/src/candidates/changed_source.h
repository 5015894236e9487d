#pragma once

#include "candidates/surface_pair.h"
#include "geometry/rigid.h"

namespace emtr {

/// Returns the best score of the mirror image of the source, near the pose: that of the poses which
/// mirror the clouds laid together in one of their axes. Minus infinity when none of them is worth
/// a closer look, as for most scenes: a mirrored cloud is only taken for the right one where the
/// scene looks much like its own mirror image.
double mirrored_score(const SurfacePair& surfaces, const Rigid& pose, const Kernels& kernels);

/// The source at another scale.
struct Rescaled {
  double factor = 1;  ///< times the source's lengths
  double score = 0;   ///< of the best pose at that scale
};

/// Looks for the scale of the source, 0.75 to 1.33, at which it fits best near the pose:
/// Gauss-Newton over a similarity, point to plane, with annealed Tukey weights; then the score at
/// that scale. The factor is 1 when the best one is within 5 percent of it, which surfaces of depth
/// cameras prefer by their own error.
Rescaled best_scale(const SurfacePair& surfaces, const Rigid& pose, const Kernels& kernels);

}  // namespace emtr
