#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "candidates/candidate_set.h"
#include "refinement/hessian_spectrum.h"

namespace emtr {

/// The self-symmetry of what both clouds show together: a motion after which they fit about as
/// well.
struct Symmetry {
  enum Kind { None, Rotational, Continuous, Translational };
  Kind kind = None;
  int order = 0;  ///< n: rotations by 360 / n degrees; 0 unless rotational
  /// Direction of the rotations' axis or the translations, in the target's axes; NaN: there is
  /// none.
  Eigen::Vector3d axis = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  /// Length of the shortest translation found, radii; 0 where any is one; NaN unless translational.
  double period = std::numeric_limits<double>::quiet_NaN();
};

/// Returns "none", "rotational", "continuous" (any rotation about the axis) or "translational".
const char* name_of(Symmetry::Kind kind);

/// Finds the symmetry by which about as good alternatives differ from the best candidate; where the
/// surfaces leave directions unconstrained, the one that these make. `alternatives`: best first,
/// each clearly different from the others. `spectrum`: of the refined pose, or null.
Symmetry find_symmetry(const Candidate& best, const std::vector<Candidate>& alternatives,
                       const HessianSpectrum* spectrum);

}  // namespace emtr
