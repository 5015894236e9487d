// Transforms points and sums rho, the M-estimator. Included by each instruction set's file.

#include "kernels/lanes.h"

namespace emtr::EMTR_KERNEL {
namespace {

void transform(const PointsView& p, const float* R, const float* t, float* x, float* y, float* z) {
  float* out[3] = {x, y, z};
  std::size_t i = 0;
  for (; i + kWide <= p.size; i += kWide) {
    const Sixteen px = load<kWide>(p.x + i);
    const Sixteen py = load<kWide>(p.y + i);
    const Sixteen pz = load<kWide>(p.z + i);
    for (std::size_t a = 0; a < 3; ++a)
      store<kWide, Floats>(
          out[a] + i, ((broadcast<kWide>(R[3 * a]) * px + broadcast<kWide>(R[3 * a + 1]) * py) +
                       broadcast<kWide>(R[3 * a + 2]) * pz) +
                          broadcast<kWide>(t[a]));
  }
  for (; i < p.size; ++i) {
    const float px = p.x[i], py = p.y[i], pz = p.z[i];
    for (std::size_t a = 0; a < 3; ++a)
      out[a][i] = ((R[3 * a] * px + R[3 * a + 1] * py) + R[3 * a + 2] * pz) + t[a];
  }
}

EMTR_INLINE double rho(float squared, float inverse) {
  const float w = 1.0f - squared * inverse;
  return static_cast<double>(1.0f - w * w * w);
}

double rho_sum(const float* squared, std::size_t n, float inverse) {
  double sum[kLanes] = {};
  std::size_t i = 0;
  for (; i + kLanes <= n; i += kLanes)
    for (std::size_t l = 0; l < kLanes; ++l) sum[l] += rho(squared[i + l], inverse);
  for (std::size_t l = 0; i < n; ++i, ++l) sum[l] += rho(squared[i], inverse);
  return ((sum[0] + sum[4]) + (sum[2] + sum[6])) + ((sum[1] + sum[5]) + (sum[3] + sum[7]));
}

}  // namespace
}  // namespace emtr::EMTR_KERNEL
