#pragma once

#include <cstddef>
#include <vector>

#include "candidates/candidate_set.h"
#include "colors/color_correlation.h"

namespace emtr {

/// A candidate with what the colors of both clouds say of it.
struct ColoredCandidate {
  Candidate candidate;
  ColorEvidence colors;
};

inline const Rigid& pose_of(const ColoredCandidate& candidate) { return candidate.candidate.pose; }

/// Whether the colors tell which candidate is right.
struct ColorVerdict {
  std::size_t best = 0;    ///< of the candidates, by shape and colors together
  bool decided = false;    ///< the colors prove it: more than chance, and more than any other's
  double probability = 0;  ///< that no other candidate is right, where decided
};

/// Tells whether colors that agree so well do so by more than chance, in the best of so many poses.
bool is_more_than_chance(double evidence, std::size_t poses);

/// Judges candidates, no two of them the same pose. The logarithm of a likelihood ratio is the sum
/// of the colors' evidence and of a term of the score: surfaces that lie on each other in several
/// poses say little about which one. `looked_at`: poses among which these have been found.
ColorVerdict judge_by_colors(const std::vector<ColoredCandidate>& candidates,
                             std::size_t looked_at);

}  // namespace emtr
