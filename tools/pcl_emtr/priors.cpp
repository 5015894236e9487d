#include "priors.h"

#include <cmath>

#include "failure.h"
#include "numbers.h"
#include "setting_text.h"

namespace cli {
namespace {

constexpr char kGroup[] = "priors";

double number(const CLI::Option& option, const std::string& text) {
  const auto value = parse_real(text);
  if (!value || !std::isfinite(*value))
    throw UsageFailure(option.get_name() + ": '" + text + "' is not a finite number, expected " +
                       option.get_type_name());
  return *value;
}

}  // namespace

Priors::Priors(CLI::App& app) {
  axis_option_ = app.add_option(
      "--axis", axis_,
      wrapped("only rotations about this direction, the same in both clouds' frames: up, for "
              "scanners that know where down is",
              66));
  axis_option_->type_name("X Y Z")->group(group_of(kGroup));
  bounds_option_ =
      app.add_option("--translation-bounds", bounds_,
                     wrapped("least and largest translation of T, in the clouds' unit", 66));
  bounds_option_->type_name("X0 Y0 Z0 X1 Y1 Z1")->group(group_of(kGroup));
}

void Priors::apply(emtr_settings& settings) const {
  if (axis_option_->count() > 0) {
    for (std::size_t i = 0; i < 3; ++i) settings.axis[i] = number(*axis_option_, axis_[i]);
    settings.has_axis = 1;
  }
  if (bounds_option_->count() == 0) return;
  for (std::size_t i = 0; i < 3; ++i) {
    settings.translation_minimum[i] = number(*bounds_option_, bounds_[i]);
    settings.translation_maximum[i] = number(*bounds_option_, bounds_[i + 3]);
  }
  settings.has_translation_bounds = 1;
}

}  // namespace cli
