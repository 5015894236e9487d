#pragma once

#include <vector>

#include "preprocessing/preprocessed_cloud.h"
#include "settings/settings.h"

namespace emtr {

/// The scales that a run looks at: 2^x times a first guess, lowest <= x <= highest (octaves).
struct ScaleRange {
  double guess;  ///< of the source's lengths: the one at which both clouds are equally large
  double lowest, highest;  ///< octaves about the guess

  double scale(double octaves) const;
  double octaves(double scale) const;
};

/// Returns the range that the settings leave. The root mean square radii of the clouds are within
/// 0.4 octaves of each other at the right scale for nearly all pairs of scans, so that two octaves
/// on either side are enough, and the user's bounds may leave less. A unit costs no search.
ScaleRange scale_range(const PreprocessedCloud& source, const PreprocessedCloud& target,
                       const Settings& settings);

/// Returns the factors between units of length that lie in the range, the nearest to its guess
/// first; all of them, nearest first, where none does.
std::vector<double> unit_factors(const ScaleRange& range);

}  // namespace emtr
