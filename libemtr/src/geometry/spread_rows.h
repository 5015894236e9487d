#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace emtr {

/// Returns at most `most` of the rows of a cloud, from all over it. Not at a fixed step, since the
/// points may come in a pattern; some rows can come twice.
inline std::vector<std::size_t> spread_rows(std::size_t size, std::size_t most) {
  constexpr double kGolden = 0.6180339887498949;
  std::vector<std::size_t> rows(size < most ? size : most);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const double position = kGolden * static_cast<double>(k);
    rows[k] = size <= most ? k
                           : static_cast<std::size_t>((position - std::floor(position)) *
                                                      static_cast<double>(size));
  }
  return rows;
}

}  // namespace emtr
