#include "geometry/range.h"

#include <algorithm>
#include <cstddef>

namespace emtr {

Range range_of(const std::vector<float>& numbers) {
  // In lanes, which the compiler makes vectors of; std::minmax_element() compares one by one.
  constexpr std::size_t kSideBySide = 16;
  float low[kSideBySide], high[kSideBySide];
  std::fill_n(low, kSideBySide, numbers.front());
  std::fill_n(high, kSideBySide, numbers.front());
  const auto take = [&](std::size_t lane, float v) {
    low[lane] = v < low[lane] ? v : low[lane];
    high[lane] = v > high[lane] ? v : high[lane];
  };
  std::size_t i = 0;
  for (; i + kSideBySide <= numbers.size(); i += kSideBySide)
    for (std::size_t lane = 0; lane < kSideBySide; ++lane) take(lane, numbers[i + lane]);
  for (; i < numbers.size(); ++i) take(0, numbers[i]);
  return {*std::min_element(low, low + kSideBySide), *std::max_element(high, high + kSideBySide)};
}

}  // namespace emtr
