#pragma once

#include <vector>

#include "priors/prior.h"
#include "refinement/normal_equations.h"

namespace emtr {

/// How well the matched surfaces constrain a pose: the eigenvalues of their Hessian for motions
/// about the matches' own centroid, with rotations measured by how far they move a point at
/// `radius` from it, so that all six directions are lengths and neither the size nor the place of
/// the overlap counts. An eigenvalue is the mean square of the displacement along the normals for a
/// motion of length 1: the three translations have 1 between them, a direction that moves a
/// surface along itself has none. A plane leaves two translations and one rotation unconstrained, a
/// sphere three rotations, a cylinder a translation and a rotation.
struct HessianSpectrum {
  double eigenvalues[6] = {};  ///< ascending, dimensionless, in [0, about 1]
  double eigenvectors[6][6] =
      {};                 ///< of unit length, one a row: rotation vector * radius, then the
                          ///< translation of the center; in the axes of the target's frame
  double center[3] = {};  ///< of the matched points, in the target's normalized frame
  double radius = 0;      ///< their root mean square distance from it
  int unconstrained = 0;  ///< how many eigenvalues lie below kUnconstrainedEigenvalue

  /// Returns the smallest by the largest eigenvalue, in [0, 1]: 0 when a direction is
  /// unconstrained.
  double condition() const { return eigenvalues[5] > 0 ? eigenvalues[0] / eigenvalues[5] : 0; }
};

/// Noise of the normals gives an unconstrained direction its square: 0.003 is a twentieth of a
/// radian, 3 degrees.
constexpr double kUnconstrainedEigenvalue = 3e-3;

/// Returns all zeros, with six unconstrained directions, when there are no matches.
HessianSpectrum hessian_spectrum(const NormalEquations& sums);

/// Counts the unconstrained directions among those that a prior leaves: of its limits the
/// equalities take some away, such as the rotations of a sphere about axes that are known to be
/// upright.
int unconstrained_within(const HessianSpectrum& spectrum, const std::vector<Prior::Limit>& limits);

}  // namespace emtr
