#pragma once

#include <emtr/emtr.h>

#include <string>

#include "options/options.h"
#include "report/json.h"

namespace cli {

/// Adds everything that repeats the run: versions, files, preset, seed, settings, what is known of
/// the pose, and user-provided data.
void add_input(Json& out, const Options& options);

/// Adds the preset, all settings, and what is known of the pose.
void add_settings(Json& out, const std::string& preset, const emtr_settings& settings);

}  // namespace cli
