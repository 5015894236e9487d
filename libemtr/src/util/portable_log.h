#pragma once

#include <cmath>

namespace emtr {

/// Returns the logarithm to base 10 of x > 0 by basic operations alone, so that a decision that
/// hangs on it is the same with every C library.
inline double portable_log10(double x) {
  int exponent = 0;
  double m = std::frexp(x, &exponent);
  if (m < 0.7071067811865476) {
    m *= 2;
    --exponent;
  }
  const double z = (m - 1) / (m + 1), zz = z * z;  // |z| < 0.172: 11 terms are all digits
  double series = 0;
  for (int k = 21; k >= 1; k -= 2) series = series * zz + 1.0 / k;
  return 2 * z * series * 0.4342944819032518 + exponent * 0.3010299956639812;
}

}  // namespace emtr
