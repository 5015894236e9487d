#pragma once

#include <string>

#include "text/numbers.h"

namespace cli {

/// Prints a row-major matrix as four lines of four numbers with 17 digits, as numpy.loadtxt reads
/// them.
inline std::string matrix_text(const double (&matrix)[16]) {
  std::string text;
  for (int i = 0; i < 16; ++i) text += exact(matrix[i]) + (i % 4 == 3 ? "\n" : " ");
  return text;
}

}  // namespace cli
