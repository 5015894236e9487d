#include "priors/make_prior.h"

#include <cmath>
#include <string>

#include "util/error.h"

namespace emtr {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using Names = std::vector<std::string>;

constexpr double kDegree = 3.14159265358979323846 / 180;

void require(bool holds, const std::string& message) {
  if (!holds) throw Error(EMTR_ERROR_SETTING, message);
}

bool limits_rotation(const Settings& s) { return s.has_guess && s.guess_rotation < kAnyRotation; }
bool limits_translation(const Settings& s) { return s.has_guess && s.guess_translation < kAnyTranslation; }

bool finite(const double (&v)[3]) {
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

Quaterniond rotation_of(const Rigid& pose) { return Quaterniond(pose.R).normalized(); }

/// Of any length that floating point can hold, the square of which it may not.
Vector3d direction(const double v[3]) {
  const Vector3d given = Vector3d::Map(v);
  return (given / given.cwiseAbs().maxCoeff()).normalized();
}

RotationLimits rotation_limits(const Settings& s, const Rigid& guess) {
  RotationLimits out;
  if (limits_rotation(s)) out.balls.push_back({rotation_of(guess), s.guess_rotation * kDegree});
  if (s.maximum_rotation < kAnyRotation)
    out.balls.push_back({Quaterniond::Identity(), s.maximum_rotation * kDegree});
  if (s.has_axis) {
    const double half = (s.axis_angle_maximum - s.axis_angle_minimum) / 2;
    Arc angle;
    if (half < 180)
      angle = {(s.axis_angle_minimum + s.axis_angle_maximum) / 2 * kDegree, half * kDegree};
    out.axis = {direction(s.axis), s.axis_tilt * kDegree, angle};
  }
  return out;
}

/// In the normalized frame. No pose in sight has its origin further away than that: larger numbers
/// say nothing, and would blur the smaller ones.
TranslationBox translation_box(const Settings& s, const Normalization& normalization) {
  const auto corner = [&](const double* at) -> Vector3d {
    return (Vector3d::Map(at) - Vector3d::Map(normalization.center_target)) / normalization.scale;
  };
  TranslationBox box{corner(s.translation_minimum), corner(s.translation_maximum),
                     Vector3d::Map(normalization.center_source) / normalization.scale};
  const double sight = kFarthest + box.lever.norm();
  require(
      box.low.maxCoeff() <= sight && box.high.minCoeff() >= -sight,
      "settings 'translation_minimum' and 'translation_maximum' keep the source a million radii "
      "away from the target");
  box.low = box.low.cwiseMax(-sight);
  box.high = box.high.cwiseMin(sight);
  return box;
}

TranslationLimits translation_limits(const Settings& s, const Normalization& normalization, const Rigid& guess) {
  TranslationLimits out;
  if (limits_translation(s)) out.ball = {guess.t, s.guess_translation / normalization.scale};
  if (s.has_translation_bounds) out.box = translation_box(s, normalization);
  return out;
}

Names rotation_names(const Settings& s) {
  Names out;
  if (limits_rotation(s)) out.push_back("'guess_rotation'");
  if (s.has_axis) out.push_back("'axis'");
  if (s.maximum_rotation < kAnyRotation) out.push_back("'maximum_rotation'");
  return out;
}

Names all_names(const Settings& s) {
  Names out = rotation_names(s);
  if (limits_translation(s)) out.push_back("'guess_translation'");
  if (s.has_translation_bounds) out.push_back("'translation_minimum' to 'translation_maximum'");
  return out;
}

[[noreturn]] void contradict(const Names& names, const char* what) {
  std::string text = "settings ";
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  throw Error(EMTR_ERROR_SETTING, text + " contradict each other: no " + what + " is within all");
}

/// Where the search for an admissible pose starts.
std::vector<Rigid> starts(const Settings& s, const RotationLimits& rotation, const Rigid& guess) {
  std::vector<Rigid> out = {guess, Rigid()};
  if (s.has_guess) {
    out.emplace_back();
    out.back().t = guess.t;
  }
  if (rotation.axis) {
    const Arc angles = rotation.angles().value_or(rotation.axis->angle);
    for (const double at : {0.0, -0.5, 0.5}) {
      const Eigen::AngleAxisd about_axis(angles.middle + at * angles.half, rotation.axis->axis);
      out.push_back(guess);
      out.back().R = about_axis.toRotationMatrix();
    }
  }
  return out;
}

}  // namespace

void validate_priors(const Settings& s) {
  const auto needs = [](bool given, bool there, const char* name, const char* other) {
    require(!given || there,
            std::string("setting '") + name + "' says nothing without '" + other + "'");
  };
  needs(s.guess_rotation < kAnyRotation, s.has_guess, "guess_rotation", "guess");
  needs(s.guess_translation < kAnyTranslation, s.has_guess, "guess_translation", "guess");
  needs(s.axis_tilt > 0, s.has_axis, "axis_tilt", "axis");
  needs(s.axis_angle_minimum != -180, s.has_axis, "axis_angle_minimum", "axis");
  needs(s.axis_angle_maximum != 180, s.has_axis, "axis_angle_maximum", "axis");
  require(s.axis_angle_minimum <= s.axis_angle_maximum,
          "settings 'axis_angle_minimum' and 'axis_angle_maximum' contradict each other: the "
          "minimum is the larger one");
  if (s.has_axis)
    require(finite(s.axis) && Vector3d::Map(s.axis).cwiseAbs().maxCoeff() > 0,
            "setting 'axis' is no direction: expected finite x, y, z that are not all 0");
  if (!s.has_translation_bounds) return;
  require(finite(s.translation_minimum) && finite(s.translation_maximum),
          "settings 'translation_minimum' and 'translation_maximum' are not finite: expected x, y, "
          "z; a side that has no limit takes a large number");
  for (int i = 0; i < 3; ++i)
    require(s.translation_minimum[i] <= s.translation_maximum[i],
            std::string("settings 'translation_minimum' and 'translation_maximum' contradict each "
                        "other: the minimum of ") +
                "xyz"[i] + " is the larger one");
}

Rigid normalized_guess(const Settings& settings, const Normalization& normalization) {
  Rigid pose = normalization.to_normalized(from_matrix(settings.guess));
  require(is_near(pose.t.data(), 3), "setting 'guess' moves the source a million radii past the target");
  // As people write matrices down, it is a rotation to three digits: the results are to all.
  pose.R = rotation_of(pose).toRotationMatrix();
  return pose;
}

PriorPtr make_prior(const Settings& s, const Normalization& normalization) {
  const Rigid guess = s.has_guess ? normalized_guess(s, normalization) : Rigid();
  RotationLimits rotation = rotation_limits(s, guess);
  const TranslationLimits translation = translation_limits(s, normalization, guess);
  if (!rotation.any() && !translation.any()) return nullptr;
  if (!rotation.simplify()) contradict(rotation_names(s), "rotation");
  bool turned = false;
  for (const Rigid& start : starts(s, rotation, guess)) {
    const Rigid found = Prior::attempt(rotation, translation, start);
    if (Prior::holds(rotation, translation, found))
      return std::make_unique<const Prior>(std::move(rotation), translation, found);
    turned |= Prior::holds(rotation, TranslationLimits(), found);
  }
  if (!turned) contradict(rotation_names(s), "rotation");
  contradict(all_names(s), "pose");
}

}  // namespace emtr
