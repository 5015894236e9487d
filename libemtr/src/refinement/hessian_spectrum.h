#pragma once

#include <vector>

#include "priors/prior.h"
#include "refinement/normal_equations.h"

namespace emtr {

/// What the matched surfaces hold a pose by: the eigenvalues of their Hessian for motions about the
/// matches' own centroid, with rotations measured by how far they move a point at `radius` from it,
/// so that all six directions are lengths and neither the size nor the place of the overlap counts.
/// An eigenvalue is the mean square of the shift along the normals for a motion of length 1: the
/// three shifts have 1 between them, a direction that slides a surface along itself has none. A
/// plane leaves two slides and one spin free, a sphere three spins, a cylinder a slide and a spin.
struct HessianSpectrum {
  double values[6] = {};         ///< ascending, dimensionless, of [0, about 1]
  double directions[6][6] = {};  ///< unit vectors, one a row: rotation vector * radius, then the
                                 ///< shift of the centre; in the axes of the target's frame
  double center[3] = {};         ///< of the matched points, in the target's normalized frame
  double radius = 0;             ///< their root mean square distance from it
  int free = 0;                  ///< how many values lie below kUnconstrainedEigenvalue

  /// Smallest by largest eigenvalue, of [0, 1]: 0 when something is free.
  double condition() const { return values[5] > 0 ? values[0] / values[5] : 0; }
};

/// Noise of the normals gives a free direction its square: 0.003 is a twentieth of a radian, 3
/// degrees.
constexpr double kUnconstrainedEigenvalue = 3e-3;

/// All zeros, with six free directions, when there are no matches.
HessianSpectrum hessian_spectrum(const NormalEquations& sums);

/// How many directions are free among those that a prior leaves: of its limits the equalities take
/// some away, such as the spins of a sphere about axes that are known to be upright.
int unconstrained_within(const HessianSpectrum& hessian_spectrum, const std::vector<Prior::Limit>& limits);

}  // namespace emtr
