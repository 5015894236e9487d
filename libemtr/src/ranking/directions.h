#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace emtr {

using Direction = std::array<double, 3>;

/// Spreads directions evenly over the sphere, each one golden angle further: by repeated rotation
/// and not by sines and cosines, whose last bits differ from machine to machine.
inline std::vector<Direction> spread_directions(std::size_t count) {
  constexpr double cosine = -0.7373688780783197, sine = 0.6754902942615238;
  std::vector<Direction> out(count);
  double c = 1, s = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(count);
    const double r = std::sqrt(1 - z * z);
    out[i] = {r * c, r * s, z};
    const double next = cosine * c - sine * s;
    s = sine * c + cosine * s;
    c = next;
  }
  return out;
}

}  // namespace emtr
