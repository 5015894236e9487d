#pragma once

#include "candidates/candidate_set.h"
#include "settings/settings.h"

namespace emtr {

/// How the best candidate stands among the others, and what may be believed of it.
struct Confidence {
  double gap = 0;                 ///< score minus that of the best clearly different candidate
  double confidence = 0;          ///< held probability that it is right, a multiple of 1e-6
  std::vector<Candidate> others;  ///< clearly different from the best and from each other
};

/// `ranked`: of a pool, best first, not empty. `source`, `target`: points of the surfaces.
Confidence estimate_confidence(const std::vector<Candidate>& ranked, std::size_t source, std::size_t target);

/// The confidence once the refined surfaces have been laid on each other, see surface_mismatch().
double lower_confidence(double confidence, double surface_mismatch);

/// Why the best candidate is held to be right, or not. `slides`: the surfaces do not hold it in all
/// directions. `correspondences`: how many matches there were.
emtr_reason reason(const Candidate& best, const Confidence& standing, bool unconstrained,
                   std::size_t correspondences, const Settings& settings);

}  // namespace emtr
