#pragma once

#include <emtr/emtr.h>

#include <string>
#include <vector>

namespace cli {

/// Returns the names of the library's presets.
std::vector<std::string> presets();

/// Returns the library's presets: "default, fast, thorough or paper".
std::string preset_names();

/// Sets every setting to its value in the preset; throws UsageFailure when there is no such preset.
void begin_with_preset(const std::string& preset, emtr_settings& settings);

}  // namespace cli
