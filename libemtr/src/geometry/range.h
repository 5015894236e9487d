#pragma once

#include <vector>

namespace emtr {

/// The least and the largest of some numbers.
struct Range {
  float low, high;
};

/// Returns the range of numbers that are not NaN; there must be one.
Range range_of(const std::vector<float>& numbers);

}  // namespace emtr
