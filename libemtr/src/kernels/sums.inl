// Transforms points and sums rho, the M-estimator. Included by each instruction set's file.

#include "kernels/lanes.h"
#include "kernels/search_kernels.h"

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

void add_rho(const float* squared, std::size_t n, float inverse, double* sums) {
  double sum[kLanes];
  for (std::size_t l = 0; l < kLanes; ++l) sum[l] = sums[l];
  std::size_t i = 0;
  for (; i + kLanes <= n; i += kLanes)
    for (std::size_t l = 0; l < kLanes; ++l) sum[l] += rho(squared[i + l], inverse);
  for (std::size_t l = 0; i < n; ++i, ++l) sum[l] += rho(squared[i], inverse);
  for (std::size_t l = 0; l < kLanes; ++l) sums[l] = sum[l];
}

double rho_sum(const float* squared, std::size_t n, float inverse) {
  double sum[kLanes] = {};
  add_rho(squared, n, inverse, sum);
  return total_of_lanes(sum);
}

}  // namespace
}  // namespace emtr::EMTR_KERNEL
