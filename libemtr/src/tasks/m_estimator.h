#pragma once

namespace emtr {

/// Returns Tukey's biweight, normalized: rho(r) = 1 - (1 - (r/c)^2)^3 for r <= c, else 1. Takes the
/// squared residual, which must already be cut at c^2. Kernels::rho_sum sums many.
inline float rho(float squared, float inverse_squared_scale) {
  const float w = 1.0f - squared * inverse_squared_scale;
  return 1.0f - w * w * w;
}

/// Returns the weight of a residual in reweighted least squares: (1 - (r/d)^2)^2 for r <= d, else
/// 0.
inline double tukey_weight(double squared, double squared_scale) {
  if (squared > squared_scale) return 0;
  const double w = 1 - squared / squared_scale;
  return w * w;
}

}  // namespace emtr
