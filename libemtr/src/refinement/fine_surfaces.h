#pragma once

#include <memory>

#include "../frame/frame.h"
#include "../kernels/kernels.h"
#include "../neighbors/neighbors.h"
#include "surface.h"

namespace emtr {

/// Both clouds as finely as their points allow, for the last steps: refinement and agreement.
struct FineSurfaces {
  Surface source, target;  ///< of one leaf
  /// Nearest points of each, within three leaves at least.
  std::unique_ptr<Neighbors> near_source, near_target;

  double leaf() const { return source.leaf; }
};

/// At the leaf asked for (normalised frame), or as fine as the sparser cloud allows.
FineSurfaces fine_surfaces(const NormalisedPair& pair, double leaf, const Kernels& kernels);

}  // namespace emtr
