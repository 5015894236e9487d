#include "options/priors.h"

#include "options/setting_text.h"
#include "text/words.h"

namespace cli {

Priors::Priors(CLI::App& app) {
  const std::string group = group_of("priors");
  axis_.option = app.add_option(
      "--axis", axis_.words,
      wrapped("allow only rotations about this direction, which is the same in both clouds: up, "
              "for scanners that know where down is"));
  axis_.option->type_name("X Y Z")->group(group);
  bounds_.option =
      app.add_option("--translation-bounds", bounds_.words,
                     wrapped("least and largest translation of T, in the clouds' unit"));
  bounds_.option->type_name("X0 Y0 Z0 X1 Y1 Z1")->group(group);
}

void Priors::apply(emtr_settings& settings) const {
  if (axis_.given()) {
    for (std::size_t i = 0; i < 3; ++i) settings.axis[i] = axis_[i];
    settings.has_axis = 1;
  }
  if (!bounds_.given()) return;
  for (std::size_t i = 0; i < 3; ++i) {
    settings.translation_minimum[i] = bounds_[i];
    settings.translation_maximum[i] = bounds_[i + 3];
  }
  settings.has_translation_bounds = 1;
}

}  // namespace cli
