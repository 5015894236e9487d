#pragma once

#include <memory>

#include "geometry/surface.h"
#include "kernels/kernels.h"
#include "neighbors/neighbors.h"
#include "preprocessing/normalization.h"

namespace emtr {

/// Both clouds as finely as their points allow, for the last steps: refinement and overlap.
struct FineSurfaces {
  SharedSurface source, target;  ///< with the same leaf
  /// Nearest points of each, within three leaves at least.
  SharedNeighbors near_source, near_target;

  double leaf() const { return source->leaf; }
};

/// Downsamples both at the leaf asked for (radii), or as finely as the sparser cloud
/// allows; but at `coarsest` where even that is finer: the leaf of the surfaces on which the pose
/// was found, since coarser ones would lose it again.
FineSurfaces fine_surfaces(const NormalizedPair& pair, double leaf, double coarsest,
                           const Kernels& kernels, int threads = 1);

}  // namespace emtr
