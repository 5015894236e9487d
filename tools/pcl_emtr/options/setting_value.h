#pragma once

#include <emtr/emtr.h>

#include <string>

namespace cli {

/// Sets a setting to the value that a user wrote. `called` is how the user named it, for messages.
/// Throws UsageFailure for a value of the wrong kind or out of range.
void set_setting(emtr_settings& settings, const emtr_setting_info& info, const std::string& text,
                 const std::string& called);

}  // namespace cli
