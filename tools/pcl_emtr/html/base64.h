#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cli {

/// Returns base64 of 16-bit numbers, the low byte first.
std::string base64(const std::vector<std::uint16_t>& values);

}  // namespace cli
