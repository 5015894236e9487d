#pragma once

#include <emtr/emtr.h>

#include <string>
#include <vector>

namespace cli {

// How a setting of the library reads on the command line.

/// Returns "--dense-points" for dense_points.
std::string option_name(std::string name);

/// Returns the names of a choice, by value.
std::vector<std::string> choices_of(const emtr_setting_info& info);

/// Returns what stands for the value in --help-all: "N", "X", "NAME" or "on|off".
std::string kind_of(const emtr_setting_info& info);

/// Returns what a value has to be, to end a sentence: "a whole number from 1 to 100".
std::string expected(const emtr_setting_info& info);

/// Returns meaning, unit, range and default, for --help-all.
std::string description_of(const emtr_setting_info& info);

/// Returns the group in --help-all for a part of the method.
std::string group_of(const std::string& part);

}  // namespace cli
