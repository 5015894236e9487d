#pragma once

#include <cstdint>
#include <vector>

#include "fpfh.h"

namespace emtr {

/// Rows of a source point and a target point held to be the same place.
struct Correspondence {
  std::int32_t source, target;
};

/// Mutual nearest neighbours in FPFH space, no ratio test; the `most` with the smallest distance
/// between descriptors, in that order.
std::vector<Correspondence> match(const Features& source, const Features& target, std::size_t most,
                                  int threads);

}  // namespace emtr
