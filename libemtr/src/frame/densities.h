#pragma once

#include "../settings.h"
#include "frame.h"

namespace emtr {

/// The clouds that the tasks work on: both thinned by one leaf a density, the leaf found so that
/// a count of points is met, whatever the unit and the size of the input.
struct Densities {
  double leaf_sparse = 0, leaf_dense = 0;  ///< normalised frame
  Cloud source_sparse, target_sparse;
  Cloud source_dense, target_dense;
  Cloud source_normals, target_normals;  ///< of the dense clouds, if the caller gave some (unit)
};

Densities thin(const NormalisedPair& pair, const Settings& settings);

/// The dense clouds alone: the sparse ones stay empty.
Densities thin_dense(const NormalisedPair& pair, const Settings& settings);

}  // namespace emtr
