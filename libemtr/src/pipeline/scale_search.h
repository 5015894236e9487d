#pragma once

#include <vector>

#include "geometry/similarity.h"
#include "pipeline/input_cloud.h"
#include "pipeline/scale_range.h"
#include "settings/settings.h"
#include "tasks/task_gamma.h"
#include "util/cancellation.h"

namespace emtr {

/// A similarity that the clouds may have.
struct ScaleHypothesis {
  Similarity similarity;  ///< the user's unit
  /// Geometric mean of the surface-fit scores of the source on the target and of the target on the
  /// source. The arithmetic one would favor a source that shrinks: a speck lies well on anything.
  double score;
};

/// Tells whether two scales are too near for two answers.
bool is_same_scale(double a, double b);

/// Returns the settings for the source at a scale of its own: with the viewpoint that goes with it
/// and no scale left to search.
Settings settings_at_scale(const Settings& settings, double scale);

/// Searches the scale of the source, and with it the pose. Task gamma says which scales are worth
/// a look; at each of these the two other tasks search as they do where the scale is known, on few
/// points; and what they find is refined in all seven directions.
class ScaleSearch {
 public:
  /// Both clouds are preprocessed and must outlive it, as the token must.
  ScaleSearch(const InputCloud& source, const InputCloud& target, const ScaleRange& range,
              const Settings& settings, CancellationToken& token);

  /// Looks at scales near the guess, where nearly all pairs have theirs.
  void search_near();
  /// Looks at all of the range: task gamma everywhere, then scales in even steps.
  void search_everywhere();
  /// Looks at one scale.
  void search_at(double scale);

  /// Returns the scales for which most pairs of matches vote, best first.
  std::vector<double> likely_scales(std::size_t count) const;

  /// Returns what was found, best first, no two of them the same.
  const std::vector<ScaleHypothesis>& ranked() const { return ranked_; }

 private:
  bool is_same(const Similarity& a, const Similarity& b) const;
  void match_at(double octaves);
  void search_at_peaks(std::size_t count);
  void add(const ScaleHypothesis& hypothesis);

  const InputCloud &source_, &target_;
  const ScaleRange range_;
  const Settings settings_;
  CancellationToken& token_;
  TaskGamma gamma_;
  std::vector<double> matched_, searched_;  ///< octaves
  std::vector<ScaleHypothesis> ranked_;
};

}  // namespace emtr
