#pragma once

#include <cstddef>

#include "geometry/surface.h"
#include "kernels/search_kernels.h"
#include "util/constants.h"

namespace emtr {

/// Matched pairs as a structure of arrays, as the kernels read them.
template <std::size_t Most>
class MatchedPairs {
 public:
  void add(const SurfacePoint& source, const SurfacePoint& target) {
    for (int a = 0; a < 3; ++a) {
      values_[a][size_] = source.p[a];
      values_[3 + a][size_] = source.n[a];
      values_[6 + a][size_] = target.p[a];
      values_[9 + a][size_] = target.n[a];
    }
    ++size_;
  }

  /// Pads the pairs to a multiple of kLanes.
  PairsView view() {
    std::size_t padded = size_;
    for (; padded % kLanes; ++padded)
      for (int a = 0; a < 12; ++a) values_[a][padded] = a % 6 < 3 ? 0 : kNone;
    PairsView out{};
    for (int a = 0; a < 6; ++a) {
      out.source[a] = values_[a];
      out.target[a] = values_[6 + a];
    }
    out.size = padded;
    return out;
  }

 private:
  float values_[12][Most + kLanes];
  std::size_t size_ = 0;
};

}  // namespace emtr
