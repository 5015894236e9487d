#pragma once

#include <emtr/emtr.h>

#include <string>

namespace cli {

/// What --scale takes beside the names of its choices, for messages.
extern const char* const kScaleNumbers;

/// Sets a known scale or the bounds of an unknown one from "FACTOR" or "LEAST,LARGEST". Returns
/// false, with the settings as they were, when the text is neither or out of range.
bool set_scale_bounds(emtr_settings& settings, const std::string& text);

}  // namespace cli
