#pragma once

#include <memory>

#include "pipeline/input_cloud.h"
#include "pipeline/result.h"
#include "pipeline/scale_search.h"
#include "pipeline/stage_seconds.h"
#include "settings/settings.h"
#include "util/cancellation.h"

namespace emtr {

/// Tells whether the scale is to be found among units, and told exactly.
bool is_unit_scale(const Settings& settings);
/// Tells whether the scale is given.
bool is_known_scale(const Settings& settings);

/// Returns a scale of which no pose is known.
inline ScaleHypothesis scale_without_pose(double scale) { return {{scale, {}}, 0}; }

/// Rigid runs of one pair at scales that were found elsewhere. Each ends with a refinement of the
/// pose and the scale together.
class RegistrationAtScale {
 public:
  /// Both clouds are preprocessed and must outlive it, as the settings and the token must.
  RegistrationAtScale(const InputCloud& source, const InputCloud& target, const Settings& settings,
                      CancellationToken& token, const StageSeconds& seconds);

  /// Registers the source at the scale of a hypothesis, whose pose is one of the candidates; again
  /// at the refined scale and pose where that is another scale. `fallback`: whether the fallback
  /// search is made as the settings have it, or not at all.
  std::unique_ptr<Result> operator()(const ScaleHypothesis& start, bool fallback) const;

  /// Returns the hypothesis at another scale, with the source's centroid where it was.
  ScaleHypothesis rescaled(ScaleHypothesis hypothesis, double scale) const;

  /// Returns the scale that the user's bounds admit and that is nearest to this one.
  double within_bounds(double scale) const;

 private:
  Settings settings_for(const ScaleHypothesis& hypothesis, bool fallback) const;

  const InputCloud &source_, &target_;
  const Settings& settings_;
  CancellationToken& token_;
  const StageSeconds seconds_;
};

}  // namespace emtr
