#pragma once

#include <cstddef>
#include <vector>

#include "kernels/kernels.h"

namespace emtr {

/// Points of one cloud in the normalized frame, as a structure of arrays of float.
struct Cloud {
  std::vector<float> x, y, z;

  std::size_t size() const noexcept { return x.size(); }
  PointsView view() const noexcept { return {x.data(), y.data(), z.data(), x.size()}; }

  void resize(std::size_t n) {
    x.resize(n);
    y.resize(n);
    z.resize(n);
  }

  void set(std::size_t i, const float p[3]) {
    x[i] = p[0];
    y[i] = p[1];
    z[i] = p[2];
  }
};

}  // namespace emtr
