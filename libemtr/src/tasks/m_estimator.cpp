#include "m_estimator.h"

namespace emtr {

double rho_sum(const float* squared, std::size_t n, float inverse_squared_scale) {
  constexpr std::size_t lanes = 8;
  double sum[lanes] = {};
  std::size_t i = 0;
  for (; i + lanes <= n; i += lanes)
    for (std::size_t l = 0; l < lanes; ++l)
      sum[l] += static_cast<double>(rho(squared[i + l], inverse_squared_scale));
  for (std::size_t l = 0; i < n; ++i, ++l)
    sum[l] += static_cast<double>(rho(squared[i], inverse_squared_scale));
  return ((sum[0] + sum[4]) + (sum[2] + sum[6])) + ((sum[1] + sum[5]) + (sum[3] + sum[7]));
}

}  // namespace emtr
