#pragma once

#include <string>
#include <vector>

#include "priors/make_prior.h"
#include "refinement/shapes.h"

namespace emtr_test {

inline emtr::Rigid any_pose(Draw& d, double reach = 1) {
  const Eigen::Vector4d q(d.gaussian(), d.gaussian(), d.gaussian(), d.gaussian());
  emtr::Rigid out;
  out.R = Eigen::Quaterniond(q.normalized()).toRotationMatrix();
  for (int k = 0; k < 3; ++k) out.t[k] = d.uniform(-reach, reach);
  return out;
}

inline emtr::Normalization any_frame(Draw& d, double lever) {
  emtr::Normalization normalization;
  normalization.scale = std::exp(d.uniform(-3, 3));
  for (int i = 0; i < 3; ++i) {
    normalization.center_source[i] = normalization.scale * d.uniform(-lever, lever);
    normalization.center_target[i] = normalization.scale * d.uniform(-lever, lever);
  }
  return normalization;
}

/// Which limits there are; to be added up.
enum {
  kGuessRotation = 1,
  kGuessTranslation = 2,
  kAxis = 4,
  kBounds = 8,
  kLargest = 16,
  kAll = 32
};

/// Settings with these limits that `inside` (normalized) satisfies, some of them just so.
inline emtr::Settings limits_around(const emtr::Rigid& inside,
                                    const emtr::Normalization& normalization, int which, Draw& d) {
  constexpr double degree = M_PI / 180;
  emtr::Settings s = emtr::preset("default");
  const Eigen::Quaterniond q(inside.R);
  if (which & (kGuessRotation | kGuessTranslation)) {
    const double degrees = d.uniform(0, 40), away = d.uniform(0, 0.5);
    emtr::Rigid guess;
    const Eigen::Quaterniond offset(Eigen::AngleAxisd(degrees * degree, d.direction()));
    guess.R = (offset * q).toRotationMatrix();
    guess.t = inside.t + away * d.direction();
    s.has_guess = 1;
    emtr::to_matrix(normalization.to_user(guess), s.guess);
    if (which & kGuessRotation) s.guess_rotation = degrees + d.uniform(0, 30);
    if (which & kGuessTranslation)
      s.guess_translation = normalization.scale * (away + d.uniform(0, 0.3));
  }
  if (which & kAxis) {
    const Eigen::AngleAxisd whole(q);
    const bool tilts = d.uniform(0, 1) < 0.5;
    const Eigen::Vector3d axis = tilts ? d.direction() : whole.axis();
    const emtr::SwingTwist parts(q, axis);
    if (parts.tilt > M_PI / 2) return limits_around(inside, normalization, which, d);
    s.has_axis = 1;
    Eigen::Vector3d::Map(s.axis) = std::exp(d.uniform(-5, 5)) * axis;
    s.axis_tilt = tilts ? std::min(90.0, parts.tilt / degree + d.uniform(0, 10)) : 0;
    if (d.uniform(0, 1) < 0.7) {
      const double angle = std::remainder(parts.angle, 2 * M_PI) / degree;
      s.axis_angle_minimum = angle - d.uniform(0, 100);
      s.axis_angle_maximum = angle + d.uniform(0, 100);
    }
  }
  if (which & kBounds) {
    s.has_translation_bounds = 1;
    const emtr::Rigid user = normalization.to_user(inside);
    for (int i = 0; i < 3; ++i) {
      s.translation_minimum[i] = user.t[i] - normalization.scale * d.uniform(0, 0.3);
      s.translation_maximum[i] = user.t[i] + normalization.scale * d.uniform(0, 0.3);
    }
  }
  if (which & kLargest)
    s.maximum_rotation = std::min(
        179.99, emtr::rotation_distance(inside.R, emtr::Rigid().R) / degree + d.uniform(0.001, 30));
  return s;
}

}  // namespace emtr_test
