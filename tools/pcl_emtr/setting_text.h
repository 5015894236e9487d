#pragma once

#include <emtr/emtr.h>

#include <string>
#include <vector>

namespace cli {

// How a setting of the library reads on the command line.

/// "--dense-points" for dense_points.
std::string option_name(std::string name);

/// The names of a choice, by value.
std::vector<std::string> choices_of(const emtr_setting_info& info);

/// "N", "X", "NAME" or "on|off".
std::string kind_of(const emtr_setting_info& info);

/// What a value has to be, to end a sentence: "a whole number from 1 to 100".
std::string expected(const emtr_setting_info& info);

/// Meaning, unit, range and default, for --help.
std::string description_of(const emtr_setting_info& info);

/// A group of options in --help, by the part of the method.
std::string group_of(const std::string& part);

/// Breaks a text into lines of at most `width` characters.
std::string wrapped(const std::string& text, std::size_t width);

}  // namespace cli
