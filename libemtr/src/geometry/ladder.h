#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace emtr {

/// The lengths that leaves and scales are rounded to, eight to an octave, so that what is made of a
/// cloud beside one other cloud serves beside the next. They are the same numbers everywhere: no
/// library of mathematics computes them.
class Ladder {
 public:
  static constexpr int kSteps = 8;

  static double rung(int index) {
    constexpr std::array<double, kSteps> octave = {1.0,  // 2^(i / 8)
                                                   1.0905077326652577,
                                                   1.189207115002721,
                                                   1.2968395546510096,
                                                   1.4142135623730951,
                                                   1.5422108254079407,
                                                   1.681792830507429,
                                                   1.8340080864093424};
    const int octaves = index >= 0 ? index / kSteps : -((kSteps - 1 - index) / kSteps);
    return std::ldexp(octave[static_cast<std::size_t>(index - octaves * kSteps)], octaves);
  }

  /// Returns the least rung that is no smaller than the length, which is above 0.
  static double above(double length) { return rung(index_above(length)); }

  /// Returns the nearest rung, by ratio.
  static double nearest(double length) {
    const int index = index_above(length);
    const double high = rung(index), low = rung(index - 1);
    return length * length < low * high ? low : high;
  }

 private:
  static int index_above(double length) {
    int index = static_cast<int>(std::ceil(kSteps * std::log2(length)));
    while (rung(index) < length) ++index;
    while (rung(index - 1) >= length) --index;
    return index;
  }
};

}  // namespace emtr
