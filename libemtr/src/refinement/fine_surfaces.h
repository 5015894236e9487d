#pragma once

#include <memory>

#include "preprocessing/normalization.h"
#include "kernels/kernels.h"
#include "neighbors/neighbors.h"
#include "refinement/downsampled_surface.h"

namespace emtr {

/// Both clouds as finely as their points allow, for the last steps: refinement and agreement.
struct FineSurfaces {
  Surface source, target;  ///< of one leaf
  /// Nearest points of each, within three leaves at least.
  std::unique_ptr<Neighbors> near_source, near_target;

  double leaf() const { return source.leaf; }
};

/// At the leaf asked for (normalized frame), or as fine as the sparser cloud allows.
FineSurfaces fine_surfaces(const NormalizedPair& pair, double leaf, const Kernels& kernels);

}  // namespace emtr
