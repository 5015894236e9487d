#pragma once

#include <emtr/emtr.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "calls.h"
#include "input.h"

namespace fuzz {

/// Returns a number from a small range, or now and then any number.
inline double any_near(Input& input, double least, double most) {
  if (input.ConsumeIntegralInRange(0, 15) == 15) return any_double(input);
  return input.ConsumeFloatingPointInRange(least, most);
}

/// Returns true once in four times, so that most runs have few priors.
inline bool seldom(Input& input) { return input.ConsumeIntegralInRange(0, 3) == 3; }

/// Sets a guess: a rotation and a translation, of which one number may be any other.
inline void any_guess(Input& input, emtr_settings& settings) {
  if (!seldom(input)) return;
  settings.has_guess = 1;
  const Eigen::Vector3d axis(input.ConsumeIntegral<std::int8_t>(),
                             input.ConsumeIntegral<std::int8_t>(), 1);
  const Eigen::AngleAxisd rotation(input.ConsumeIntegral<std::uint8_t>() * M_PI / 64,
                                   axis.normalized());
  Eigen::Matrix<double, 4, 4, Eigen::RowMajor> guess;
  guess.setIdentity();
  guess.topLeftCorner<3, 3>() = rotation.toRotationMatrix();
  for (int k = 0; k < 3; ++k) guess(k, 3) = any_near(input, -1, 1);
  if (input.ConsumeIntegralInRange(0, 7) == 7)
    guess(input.ConsumeIntegralInRange(0, 3), input.ConsumeIntegralInRange(0, 3)) =
        any_double(input);
  std::copy_n(guess.data(), 16, settings.guess);
}

/// Sets any of the priors; together they often contradict each other.
inline void any_prior(Input& input, emtr_settings& settings) {
  const auto maybe = [&](const char* name, double least, double most) {
    if (seldom(input)) accepted(emtr_setting_set(&settings, name, any_near(input, least, most)));
  };
  any_guess(input, settings);
  if (settings.has_guess) {
    maybe("guess_rotation", 0, 60);
    maybe("guess_translation", 0, 2);
  }
  if (seldom(input)) {
    settings.has_axis = 1;
    for (double& value : settings.axis) value = any_near(input, -2, 2);
    maybe("axis_tilt", 0, 30);
    maybe("axis_angle_minimum", -180, 180);
    maybe("axis_angle_maximum", -180, 180);
  }
  if (seldom(input)) {
    settings.has_translation_bounds = 1;
    for (int k = 0; k < 3; ++k) {
      settings.translation_minimum[k] = any_near(input, -2, 1);
      settings.translation_maximum[k] = settings.translation_minimum[k] + any_near(input, 0, 2);
    }
  }
  maybe("maximum_rotation", 0, 180);
}

}  // namespace fuzz
