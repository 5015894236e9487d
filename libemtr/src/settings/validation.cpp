#include "settings/validation.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>
#include <string>

#include "geometry/rigid.h"
#include "settings/choices.h"
#include "settings/settings_table.h"
#include "util/error.h"

namespace emtr {
namespace {

void require(bool holds, const std::string& message) {
  if (!holds) throw Error(EMTR_ERROR_SETTING, message);
}

bool finite(const double (&v)[3]) {
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

bool zero(const double (&v)[3]) {
  return std::all_of(v, v + 3, [](double component) { return component == 0; });
}

void validate_ranges(const Settings& settings) {
  for (const Setting& row : setting_table())
    if (row.storage != Setting::Storage::Uint64) check_range(row.info, get(settings, row));
}

void validate_method(const Settings& s) {
  require(s.sparse_points < s.dense_points,
          "settings 'sparse_points' and 'dense_points' contradict each other: the sparse source "
          "cloud must have fewer points than both dense clouds together");
  require(s.coarse_points == 0 || s.coarse_points >= kFewestPoints,
          "setting 'coarse_points' is " + std::to_string(s.coarse_points) +
              ", expected 0 or from " + std::to_string(kFewestPoints) + " on");
  require(s.normal_radius <= s.feature_radius,
          "settings 'normal_radius' and 'feature_radius' contradict each other: a feature's "
          "neighborhood must not be smaller than a normal's");
  require(s.complement_scale_end <= s.complement_scale_start,
          "settings 'complement_scale_end' and 'complement_scale_start' contradict each other: "
          "the scale must not grow");
  require(
      s.use_colors != EMTR_ALWAYS || (s.candidates > 0 && s.refine),
      "setting 'use_colors' is on, expected 'candidates' above 0 and 'refine' on as well: colors "
      "choose among candidates, and refine");
}

void validate_known_poses(const Settings& s) {
  require(!s.has_guess || is_rigid(s.guess),
          "setting 'guess' is not a rigid transformation: expected a row-major 4x4 of a rotation, "
          "a translation and (0, 0, 0, 1)");
  require(!s.has_viewpoint_source || finite(s.viewpoint_source),
          "setting 'viewpoint_source' is not finite: expected a sensor position x, y, z");
  require(!s.has_viewpoint_target || finite(s.viewpoint_target),
          "setting 'viewpoint_target' is not finite: expected a sensor position x, y, z");
}

void validate_scale(const Settings& s) {
  const bool bounded = s.scale == ScaleSearched::Bounded;
  require(bounded || (s.scale_minimum == 1 && s.scale_maximum == 1),
          "settings 'scale_minimum' and 'scale_maximum' say nothing unless 'scale' is bounded");
  require(s.scale_minimum <= s.scale_maximum,
          "settings 'scale_minimum' and 'scale_maximum' contradict each other: the minimum is the "
          "larger one");
}

/// Refuses a limit that is set without what it limits.
void validate_dependences(const Settings& s) {
  const auto needs = [](bool limited, bool known, const char* name, const char* other) {
    require(!limited || known,
            std::string("setting '") + name + "' says nothing without '" + other + "'");
  };
  needs(s.guess_rotation < kAnyRotation, s.has_guess, "guess_rotation", "guess");
  needs(s.guess_translation < kAnyTranslation, s.has_guess, "guess_translation", "guess");
  needs(s.axis_tilt > 0, s.has_axis, "axis_tilt", "axis");
  needs(s.axis_angle_minimum != -180, s.has_axis, "axis_angle_minimum", "axis");
  needs(s.axis_angle_maximum != 180, s.has_axis, "axis_angle_maximum", "axis");
}

void validate_axis(const Settings& s) {
  require(s.axis_angle_minimum <= s.axis_angle_maximum,
          "settings 'axis_angle_minimum' and 'axis_angle_maximum' contradict each other: the "
          "minimum is the larger one");
  require(!s.has_axis || (finite(s.axis) && !zero(s.axis)),
          "setting 'axis' is no direction: expected finite x, y, z that are not all 0");
}

void validate_translation_bounds(const Settings& s) {
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

}  // namespace

void check_range(const emtr_setting_info& info, double value) {
  const bool real = info.type == EMTR_SETTING_REAL;
  const bool whole = real || value == std::floor(value);
  if (value >= info.minimum && value <= info.maximum && whole) return;  // false for NaN
  std::ostringstream message;
  message.imbue(std::locale::classic());
  message.precision(17);
  message << "setting '" << info.name << "' is " << value << ", expected ";
  if (info.type == EMTR_SETTING_SWITCH)
    message << "0 or 1";
  else
    message << (real ? "a number" : "a whole number") << " from " << info.minimum << " to "
            << info.maximum;
  throw Error(EMTR_ERROR_SETTING, message.str());
}

void validate(const Settings& settings) {
  validate_ranges(settings);
  validate_method(settings);
  validate_known_poses(settings);
  validate_scale(settings);
  validate_dependences(settings);
  validate_axis(settings);
  validate_translation_bounds(settings);
}

}  // namespace emtr
