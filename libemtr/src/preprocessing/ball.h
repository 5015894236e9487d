#pragma once

namespace emtr {

/// A ball in the user's unit. Measures distances in a unit of its own, in which nothing overflows.
struct Ball {
  double center[3] = {};
  double inverse_unit = 1;    ///< a power of two, so that scaling by it costs no digits
  double squared_radius = 0;  ///< points at this distance lie outside

  double squared_distance(const double p[3]) const {
    const double x = (p[0] - center[0]) * inverse_unit, y = (p[1] - center[1]) * inverse_unit,
                 z = (p[2] - center[2]) * inverse_unit;
    return x * x + y * y + z * z;
  }
  bool contains(const double p[3]) const { return squared_distance(p) < squared_radius; }
};

}  // namespace emtr
