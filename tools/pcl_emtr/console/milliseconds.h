#pragma once

#include <cstdio>
#include <string>

namespace cli {

/// Prints a time with three digits: "3.21 ms" for 0.00321 seconds.
inline std::string milliseconds(double seconds) {
  char text[32];
  const double value = 1e3 * seconds;
  std::snprintf(text, sizeof text, value < 100 ? "%.3g ms" : "%.0f ms", value);
  return text;
}

}  // namespace cli
