#pragma once

#include <memory>
#include <vector>

#include "geometry/rigid.h"
#include "priors/rotation_limits.h"
#include "priors/translation_limits.h"

namespace emtr {

/// The set of admissible poses, known before the search, in the normalized frame. It never changes,
/// so threads may share it.
class Prior {
 public:
  static constexpr double kTolerance = 1e-10;  ///< radians and radii, beside rounding

  /// Takes an admissible pose `inside`; see make_prior().
  Prior(RotationLimits rotation, TranslationLimits translation, const Rigid& inside);

  bool admits(const Rigid& pose) const;

  /// Returns the nearest admissible pose, first in rotation and then in translation; an admissible
  /// pose stays as it is. Where several limits of the rotation meet, alternating projections find a
  /// pose near the nearest one. Should they not end inside, it returns the last admissible pose on
  /// the way from the pose known to be inside, so that the result is always admissible.
  Rigid project(const Rigid& pose) const;

  /// A limit as seen from an admissible pose: a small motion x on the left, rotation vector and
  /// translation as in moved(), must have J x <= room or, for an `equality`, J x = 0.
  struct Limit {
    double J[6];
    double room;
    bool equality;
  };
  std::vector<Limit> limits(const Rigid& pose) const;

  const RotationLimits& rotation() const { return rotation_; }
  const TranslationLimits& translation() const { return translation_; }

  /// Projects without the way back, so that the result may not be admissible. Serves make_prior().
  static Rigid attempt(const RotationLimits& rotation, const TranslationLimits& translation,
                       const Rigid& pose);
  static bool holds(const RotationLimits& rotation, const TranslationLimits& translation,
                    const Rigid& pose);

 private:
  RotationLimits rotation_;
  TranslationLimits translation_;
  Rigid inside_;
};

using PriorPtr = std::unique_ptr<const Prior>;  ///< null: every pose is admissible

/// Returns the nearest admissible poses of those that are admissible or nearly so; all poses
/// without a prior.
std::vector<Rigid> admissible(const std::vector<Rigid>& poses, const Prior* prior);

}  // namespace emtr
