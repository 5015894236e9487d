#pragma once

#include "geometry/rigid.h"

namespace emtr {

/// Returns the pose after a small motion on the left, y <- exp(x[0..2]) y + x[3..5]: x is a
/// rotation vector (radians) and a translation. The rotation stays orthonormal to the last digit,
/// however many motions follow each other.
Rigid moved(const Rigid& pose, const double x[6]);

}  // namespace emtr
