#pragma once

#include <cstddef>
#include <vector>

namespace emtr {

/// Points of one cloud in the normalised frame, as a structure of arrays of float.
struct Cloud {
  std::vector<float> x, y, z;

  std::size_t size() const noexcept { return x.size(); }

  void resize(std::size_t n) {
    x.resize(n);
    y.resize(n);
    z.resize(n);
  }
};

}  // namespace emtr
