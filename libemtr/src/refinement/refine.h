#pragma once

#include "priors/prior.h"
#include "refinement/fine_surfaces.h"
#include "refinement/hessian_spectrum.h"
#include "settings/settings.h"

namespace emtr {

/// The answer after refinement on the fine surfaces.
struct Refined {
  bool succeeded = false;       ///< false: the pose is the one at the start
  Rigid pose;                   ///< normalized frame
  double rmse = 0;              ///< see LocalRefinementResult
  double information[36] = {};  ///< see information()
  double design_effect = 1;     ///< see LocalRefinement::design_effect()
  HessianSpectrum hessian_spectrum;
  int unconstrained = 0;  ///< directions that neither the surfaces constrain nor the prior
};

/// Refines the best pose and measures how well it is constrained. `prior`: admits the start, and
/// the result too; or null.
Refined refine(const FineSurfaces& fine, const Rigid& start, const Settings& settings,
               const Kernels& kernels, const Prior* prior);

}  // namespace emtr
