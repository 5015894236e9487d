#pragma once

#include "candidates/candidate_set.h"
#include "candidates/changed_source.h"
#include "settings/settings.h"

namespace emtr {

/// What may be believed of the best candidate, and what else may be the answer.
struct Confidence {
  double probability = 0;   ///< estimated, that it is right; a multiple of 1e-6
  double score_gap = 0;     ///< its score minus that of the best clearly different candidate
  double evidence = 0;      ///< how many points of the poorer cloud lie on the other
  bool mirrored = false;    ///< the mirror image of the source fits better
  double scale_factor = 1;  ///< of the source, at which it fits better; 1: none does
  std::vector<Candidate> alternatives;  ///< clearly different from it and from each other
};

/// Tells whether what lies on the other cloud is mostly what lies there in many poses, planes: then
/// a better pose may not have been found. It is so of few right poses.
bool is_mostly_plane(const Candidate& candidate);

/// Tells whether nearly all that is distinctive of the clouds lies nowhere near the other one.
bool is_hardly_explained(const Candidate& candidate);

/// Tells whether another answer has half of the best one's score and more. It is so of few right
/// poses, but where the scene repeats itself: there the right one may not have been found.
bool is_nearly_rivaled(const Candidate& best, const Confidence& confidence);

/// Returns how many points of the poorer cloud lie on the other. `source`, `target`: numbers of
/// points of the surfaces.
double evidence(const Candidate& candidate, std::size_t source, std::size_t target);

/// Tells whether a candidate of this score is another answer beside the best.
bool is_rival_score(double score, double best);

/// Estimates the confidence in the best candidate. `ranked`: candidates, best first, not empty.
/// `source`, `target`: numbers of points of the surfaces.
Confidence estimate_confidence(const std::vector<Candidate>& ranked, std::size_t source,
                               std::size_t target);

/// Returns the probability when another answer is as good that was found elsewhere.
double lower_for_rival(double probability);

/// Returns the probability when the pose was looked for at many scales: the more are looked at, the
/// more often a wrong one fits as well.
double lower_for_many_scales(double probability);

/// Lowers the probability when the source fits better mirrored or at another scale: then no rigid
/// motion is right. `mirrored`: its best score.
void weigh_changed_source(const Candidate& best, double mirrored, const Rescaled& rescaled,
                          Confidence& confidence);

/// Returns the probability once the refined surfaces have been laid on each other, see
/// surface_mismatch().
double lower_confidence(double probability, double surface_mismatch);

/// Returns the probability of a best candidate of two outlines, which fit by chance better than two
/// surfaces do.
double lower_outline_confidence(double probability, double score);

/// Tells why the best candidate is taken to be right, or not. `unconstrained`: the surfaces leave
/// some direction open. `correspondences`: how many matches there were.
emtr_reason reason(const Candidate& best, const Confidence& confidence, bool unconstrained,
                   std::size_t correspondences, const Settings& settings);

}  // namespace emtr
