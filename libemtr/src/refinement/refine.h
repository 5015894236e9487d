#pragma once

#include "priors/prior.h"
#include "settings/settings.h"
#include "refinement/fine_surfaces.h"
#include "refinement/hessian_spectrum.h"

namespace emtr {

/// The answer polished on the fine surfaces.
struct Refined {
  bool succeeded = false;       ///< false: nothing held the pose, which is the one at the start
  Rigid pose;                   ///< normalized frame
  double rmse = 0;              ///< see Polished
  double information[36] = {};  ///< see information()
  HessianSpectrum hessian_spectrum;
  int unconstrained = 0;  ///< directions that neither the surfaces hold nor the prior
};

/// `prior`: what the pose keeps to, as the start does, or null.
Refined refine(const FineSurfaces& fine, const Rigid& start, const Settings& settings,
               const Kernels& kernels, const Prior* prior);

}  // namespace emtr
