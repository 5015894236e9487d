#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "correspondences/match_points.h"

namespace emtr {

/// Task gamma scores a scale on what neither a rotation nor a translation changes: the ratio of the
/// lengths |q_i - q_j| / |p_i - p_j| of each pair of matches. It is one more cut of the solution
/// space: gamma searches the logarithm of the scale alone, and its best values are the scales at
/// which task beta and task alpha search rotation and translation.
///
/// Each pair votes for the scales that its noise admits, x +- log2(e) leaf / |q_i - q_j| about x =
/// log2 of its ratio, in octaves. A scale's score is the sum over the matches i of c_i(x)^2, where
/// c_i counts the votes of the pairs at i: a right match has votes from all the other right ones,
/// a wrong one from few. One dimension is small enough to evaluate everywhere, so gamma needs no
/// swarm.
class TaskGamma {
 public:
  static constexpr int kBinsOfOctave = 128;

  struct Peak {
    double octaves;  ///< log2 of the scale
    double score;
  };

  /// `lowest`, `highest`: octaves, the range in which scales are scored.
  TaskGamma(double lowest, double highest);

  /// Adds the votes of matches whose source points were multiplied by 2^`octaves` before. Of them
  /// only scales within `half_width` octaves count, the less the farther away: descriptors match
  /// badly at another scale. `leaf`: in the unit of the target's points.
  void add(const MatchPoints& matches, double leaf, double octaves, double half_width, int threads);

  /// Returns the score of a scale, higher is better; 0 outside of the range.
  double evaluate(double octaves) const;

  /// Returns at most `count` scales whose score no other within a tenth of an octave exceeds, best
  /// first; without those whose score is 0.
  std::vector<Peak> peaks(std::size_t count) const;

 private:
  double octaves_of(std::size_t bin) const;

  double lowest_;
  std::vector<double> scores_;
};

}  // namespace emtr
