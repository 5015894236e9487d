#pragma once

#include <emtr/emtr.h>

#include <algorithm>

namespace pcl {
namespace detail {

/** \brief Copies the priors, which belong to the clouds and not to the method. */
inline void copyPriors(const emtr_settings& from, emtr_settings& to) {
  to.guess_rotation = from.guess_rotation;
  to.guess_translation = from.guess_translation;
  to.has_axis = from.has_axis;
  std::copy_n(from.axis, 3, to.axis);
  to.axis_tilt = from.axis_tilt;
  to.axis_angle_minimum = from.axis_angle_minimum;
  to.axis_angle_maximum = from.axis_angle_maximum;
  to.has_translation_bounds = from.has_translation_bounds;
  std::copy_n(from.translation_minimum, 3, to.translation_minimum);
  std::copy_n(from.translation_maximum, 3, to.translation_maximum);
  to.maximum_rotation = from.maximum_rotation;
}

/** \brief Checks whether the priors keep poses near the guess. A NaN counts as a limit, so that the
 * library reports it. */
inline bool limitsGuess(const emtr_settings& settings) {
  return !(settings.guess_rotation >= 180 && settings.guess_translation >= 1e12);
}

}  // namespace detail
}  // namespace pcl
