#pragma once

#include "settings/settings.h"

namespace emtr {

/// Checks a value against its row of the table. Throws Error naming the setting and its range.
void check_range(const emtr_setting_info& info, double value);

/// Checks all settings before they are used. Throws Error on a value out of range, on settings that
/// contradict each other, on a prior that no cloud could go with, and on a guess that is no rigid
/// transformation.
void validate(const Settings& settings);

}  // namespace emtr
