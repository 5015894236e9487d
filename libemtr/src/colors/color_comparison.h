#pragma once

#include <memory>

#include "colors/color_search.h"
#include "colors/photometric_refinement.h"
#include "preprocessing/normalization.h"

namespace emtr {

/// The colors of two clouds, ready to judge, search and refine poses.
class ColorComparison {
 public:
  /// All but the channels must outlive it.
  ColorComparison(const FineSurfaces& fine, const Channels& channels, const Kernels& kernels)
      : levels(fine, channels, kernels), refinement(fine, channels, kernels) {}

  const ColorLevels levels;
  const PhotometricRefinement refinement;
};

/// Tells whether both clouds have colors, or both intensities.
bool have_comparable_colors(const NormalizedPair& pair);

/// Returns the comparison; null where the clouds have no comparable colors, or these tell nothing:
/// they do not vary, or not from place to place but from point to point, as noise does.
std::unique_ptr<ColorComparison> compare_colors(const NormalizedPair& pair,
                                                const FineSurfaces& fine, const Kernels& kernels);

}  // namespace emtr
