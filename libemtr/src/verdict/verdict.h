#pragma once

#include "evolution/engine.h"

namespace emtr {

/// How well a pose explains the clouds, and whether it is taken to be right.
struct Verdict {
  bool registered = false;
  emtr_reason reason = EMTR_REASON_LOW_OVERLAP;
  double fitness = 1;              ///< mean of rho over both dense clouds
  double inlier_ratio_source = 0;  ///< within c of the D stage
  double inlier_ratio_target = 0;
  double fitness_gap = 0;  ///< mean fitness of the best clearly different pose, minus fitness
};

/// Judges a pose, the evolution's best or one made from it. `correspondences`: how many matches
/// task beta had.
Verdict judge(const Evolution& evolution, const Rigid& pose, const TaskAlpha& alpha,
              std::size_t correspondences, const Settings& settings);

}  // namespace emtr
