#pragma once

#include <emtr/emtr.h>

#include "geometry/similarity.h"

namespace emtr {

/// Measures how far the points of each cloud are from the other, once `similarity` has moved the
/// source: the distance to the nearest point, in the target's unit, NaN for points that are not
/// finite. Either array may be null. The nearest point is found in floats relative to the other
/// cloud's box, and its distance taken in double. Throws Error when a cloud cannot be read, or has
/// no finite point.
void residuals(const emtr_cloud& source, const emtr_cloud& target, const Similarity& similarity,
               int threads, double* source_residuals, double* target_residuals);

}  // namespace emtr
