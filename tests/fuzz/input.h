#pragma once

#include <FuzzedDataProvider.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace fuzz {

using Input = FuzzedDataProvider;

/// Ends the process unless the condition holds; libFuzzer reports that.
inline void require(bool holds) {
  if (!holds) __builtin_trap();
}

/// Returns any double: a plain one, one that often breaks things, or any eight bytes.
inline double any_double(Input& input) {
  static const double special[] = {0.0,
                                   -0.0,
                                   1.0,
                                   -1.0,
                                   0.5,
                                   2.0,
                                   1e-3,
                                   1e3,
                                   5e5,
                                   1e6,
                                   2147483647.0,
                                   2147483648.0,
                                   4294967296.0,
                                   9007199254740993.0,
                                   1e19,
                                   1e38,
                                   1e39,
                                   1e-38,
                                   1e-46,
                                   1e149,
                                   1e151,
                                   1e-150,
                                   1e-170,
                                   std::numeric_limits<double>::max(),
                                   std::numeric_limits<double>::denorm_min(),
                                   std::numeric_limits<double>::infinity(),
                                   -std::numeric_limits<double>::infinity(),
                                   std::numeric_limits<double>::quiet_NaN()};
  switch (input.ConsumeIntegralInRange(0, 2)) {
    case 0:
      return input.ConsumeIntegral<std::int16_t>() / 64.0;
    case 1:
      return input.PickValueInArray(special);
    default:
      break;
  }
  double value = 0;
  input.ConsumeData(&value, sizeof value);
  return value;
}

}  // namespace fuzz
