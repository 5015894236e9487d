#pragma once

#include "refinement/local_refinement.h"

namespace emtr {

/// Writes the inverse of the covariance of a refined pose, row-major 6x6, for a small motion on the
/// left in the target's normalized frame, about its origin (the centroid of the target): rows 0-2 a
/// rotation vector in radians, rows 3-5 a translation in the normalized unit; T_true = exp(x) T.
/// The Hessian of the matched pairs scaled by the variance of their residuals, as M-estimators are
/// (Huber 1981, 6.3), and by the design effect, which says how many pairs count as one. It knows
/// noise that is independent from point to point and nothing else: not what two scanners see
/// differently, not a wrong match, and along unconstrained directions it is as good as zero (see
/// hessian_spectrum()). All zeros when the refinement had too few inliers.
void information(const LocalRefinementResult& refined, double design_effect, double matrix[36]);

}  // namespace emtr
