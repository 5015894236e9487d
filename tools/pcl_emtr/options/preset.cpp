#include "options/preset.h"

#include "failure.h"
#include "options/suggestion.h"
#include "text/words.h"

namespace cli {

std::vector<std::string> presets() {
  std::vector<std::string> names;
  for (std::size_t i = 0; emtr_preset_name(i); ++i) names.emplace_back(emtr_preset_name(i));
  return names;
}

std::string preset_names() { return joined(presets(), " or "); }

void begin_with_preset(const std::string& preset, emtr_settings& settings) {
  if (emtr_settings_init(&settings, sizeof settings, preset.c_str()) != EMTR_OK)
    throw UsageFailure("--preset: '" + preset + "' is not one of: " + preset_names() +
                       did_you_mean(preset, presets()));
}

}  // namespace cli
