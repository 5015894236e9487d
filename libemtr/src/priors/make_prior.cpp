#include "priors/make_prior.h"

#include <string>
#include <utility>

#include "util/constants.h"
#include "util/error.h"

namespace emtr {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using Names = std::vector<std::string>;

void require(bool holds, const std::string& message) {
  if (!holds) throw Error(EMTR_ERROR_SETTING, message);
}

bool limits_rotation(const Settings& s) { return s.has_guess && s.guess_rotation < kAnyRotation; }
bool limits_translation(const Settings& s) {
  return s.has_guess && s.guess_translation < kAnyTranslation;
}

Quaterniond rotation_of(const Rigid& pose) { return Quaterniond(pose.R).normalized(); }

/// Returns the unit vector of a direction whose squared length need not fit into a double.
Vector3d unit_direction(const double v[3]) {
  const Vector3d direction = Vector3d::Map(v);
  return (direction / direction.cwiseAbs().maxCoeff()).normalized();
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
    out.axis = {unit_direction(s.axis), s.axis_tilt * kDegree, angle};
  }
  return out;
}

/// Returns the translation bounds in the normalized frame, cut at the farthest place where a pose
/// can put its origin: larger numbers say nothing, and would cost the smaller ones their digits.
TranslationBox translation_box(const Settings& s, const Normalization& normalization) {
  const auto to_normalized = [&](const double* at) -> Vector3d {
    return (Vector3d::Map(at) - Vector3d::Map(normalization.center_target)) / normalization.scale;
  };
  TranslationBox box{to_normalized(s.translation_minimum), to_normalized(s.translation_maximum),
                     Vector3d::Map(normalization.center_source) / normalization.scale};
  const double farthest = kFarthest + box.lever.norm();
  require(
      box.low.maxCoeff() <= farthest && box.high.minCoeff() >= -farthest,
      "settings 'translation_minimum' and 'translation_maximum' keep the source a million radii "
      "away from the target");
  box.low = box.low.cwiseMax(-farthest);
  box.high = box.high.cwiseMin(farthest);
  return box;
}

TranslationLimits translation_limits(const Settings& s, const Normalization& normalization,
                                     const Rigid& guess) {
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

[[noreturn]] void throw_contradiction(const Names& names, const char* what) {
  std::string text = "settings ";
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  throw Error(EMTR_ERROR_SETTING, text + " contradict each other: no " + what + " is within all");
}

/// Returns the poses from which an admissible one is looked for.
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

Rigid normalized_guess(const Settings& settings, const Normalization& normalization) {
  Rigid pose = normalization.to_normalized(from_matrix(settings.guess));
  require(is_near(pose.t.data(), 3),
          "setting 'guess' moves the source a million radii past the target");
  // People write matrices down to three digits; the results are rotations to the last one.
  pose.R = rotation_of(pose).toRotationMatrix();
  return pose;
}

PriorPtr make_prior(const Settings& s, const Normalization& normalization) {
  const Rigid guess = s.has_guess ? normalized_guess(s, normalization) : Rigid();
  RotationLimits rotation = rotation_limits(s, guess);
  const TranslationLimits translation = translation_limits(s, normalization, guess);
  if (!rotation.any() && !translation.any()) return nullptr;
  if (!rotation.simplify()) throw_contradiction(rotation_names(s), "rotation");
  bool rotation_found = false;
  for (const Rigid& start : starts(s, rotation, guess)) {
    const Rigid found = Prior::attempt(rotation, translation, start);
    if (Prior::holds(rotation, translation, found))
      return std::make_unique<const Prior>(std::move(rotation), translation, found);
    rotation_found |= Prior::holds(rotation, TranslationLimits(), found);
  }
  if (!rotation_found) throw_contradiction(rotation_names(s), "rotation");
  throw_contradiction(all_names(s), "pose");
}

}  // namespace emtr
