#pragma once

#include <cstddef>

namespace emtr {

/// Tukey's biweight, normalised: rho(r) = 1 - (1 - (r/c)^2)^3 for r <= c, else 1.
/// Taken of the squared residual, which must already be cut at c^2.
inline float rho(float squared, float inverse_squared_scale) {
  const float w = 1.0f - squared * inverse_squared_scale;
  return 1.0f - w * w * w;
}

/// Sum of rho over n squared residuals, each in float, summed in double over 8 fixed lanes, so
/// that the order of additions never depends on the machine.
double rho_sum(const float* squared, std::size_t n, float inverse_squared_scale);

/// Weight of a residual in reweighted least squares: (1 - (r/d)^2)^2 for r <= d, else 0.
inline double tukey_weight(double squared, double squared_scale) {
  if (squared > squared_scale) return 0;
  const double w = 1 - squared / squared_scale;
  return w * w;
}

}  // namespace emtr
