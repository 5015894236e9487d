#pragma once

#include "geometry/rigid.h"
#include "refinement/hessian_spectrum.h"

namespace emtr {

/// Tells whether two poses are one answer but for a motion along the unconstrained directions, as
/// large as it may be: a cylinder is the same after any rotation about its axis. `a`, `b`: from the
/// source into the target's normalized frame.
bool is_same_but_unconstrained(const Rigid& a, const Rigid& b, const HessianSpectrum& spectrum);

/// Returns the pose on the screw motion from b to a, about the spectrum's center, at this fraction
/// of the way.
Rigid between(const Rigid& a, const Rigid& b, const HessianSpectrum& spectrum, double fraction);

}  // namespace emtr
