#pragma once

#include "geometry/rigid.h"

namespace emtr {

/// The pose after a small motion on the left: x is a rotation vector (radians) and then a shift,
/// y <- exp(x[0..2]) y + x[3..5]. The rotation comes out orthonormal to the last digit, however
/// often this is done.
Rigid moved(const Rigid& pose, const double x[6]);

}  // namespace emtr
