#pragma once

#include <memory>
#include <vector>

#include "geometry/rigid.h"
#include "priors/rotation_limits.h"
#include "priors/translation_limits.h"

namespace emtr {

/// What is known of a pose before the search: a set of admissible poses, in the normalized frame.
/// Never changes, so all threads may ask it.
class Prior {
 public:
  static constexpr double kTolerance = 1e-10;  ///< radians and radii, beside what rounding does

  /// A set that has `inside` in it; see make_prior().
  Prior(RotationLimits rotation, TranslationLimits translation, const Rigid& inside);

  bool admits(const Rigid& pose) const;

  /// The nearest admissible pose, first in rotation and then in translation; an admissible pose as
  /// it is. Where several limits of the rotation meet it is found by alternating projections, which
  /// end near the nearest one. Should they not end inside, it is the last admissible pose on the
  /// way from the one that is known to be inside: what comes out is admissible in any case.
  Rigid project(const Rigid& pose) const;

  /// A limit as seen from an admissible pose: of a small motion x on the left, rotation vector and
  /// shift as in moved(), J x <= room; for an `equality` J x = 0.
  struct Limit {
    double J[6];
    double room;
    bool equality;
  };
  std::vector<Limit> limits(const Rigid& pose) const;

  const RotationLimits& rotation() const { return rotation_; }
  const TranslationLimits& translation() const { return translation_; }

  /// project() without the way back: may come out not admissible. For make_prior().
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

/// Those of the poses that are admissible or near it, as the nearest admissible ones; all of them
/// without a prior.
std::vector<Rigid> admissible(const std::vector<Rigid>& poses, const Prior* prior);

}  // namespace emtr
