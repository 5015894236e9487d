#pragma once

#include "candidates/candidate_set.h"
#include "settings/settings.h"

namespace emtr {

/// What may be believed of the best candidate, and what else may be the answer.
struct Confidence {
  double probability = 0;  ///< estimated, that it is right; a multiple of 1e-6
  double score_gap = 0;    ///< its score minus that of the best clearly different candidate
  std::vector<Candidate> alternatives;  ///< clearly different from it and from each other
};

/// Estimates the confidence in the best candidate. `ranked`: candidates, best first, not empty.
/// `source`, `target`: numbers of points of the surfaces.
Confidence estimate_confidence(const std::vector<Candidate>& ranked, std::size_t source,
                               std::size_t target);

/// Returns the probability once the refined surfaces have been laid on each other, see
/// surface_mismatch().
double lower_confidence(double probability, double surface_mismatch);

/// Tells why the best candidate is taken to be right, or not. `unconstrained`: the surfaces leave
/// some direction open. `correspondences`: how many matches there were.
emtr_reason reason(const Candidate& best, const Confidence& confidence, bool unconstrained,
                   std::size_t correspondences, const Settings& settings);

}  // namespace emtr
