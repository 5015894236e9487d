// Sums what a scanner at some place would have sampled. Included by each instruction set's file.

#include "kernels/lanes.h"
#include "kernels/search_kernels.h"

namespace emtr::EMTR_KERNEL {
namespace {

constexpr float kGrazing = 0.1f;  // of the cosine: no angle is so flat that nothing is seen

constexpr std::size_t kAside = EMTR_REGISTER >= kLanes ? kLanes : EMTR_REGISTER;
typedef float Aside __attribute__((vector_size(4 * kAside)));
typedef std::int32_t AsideInts __attribute__((vector_size(4 * kAside)));

EMTR_INLINE Aside load_aside(const float* from) {
  Aside out;
  __builtin_memcpy(&out, from, sizeof out);
  return out;
}

/// Returns the binary logarithm of positive numbers to about 1e-4, by additions and products only:
/// the last digits of a library's logarithm differ from machine to machine.
EMTR_INLINE Aside approximate_log2(const Aside& v) {
  const auto bits = (AsideInts)v;
  const Aside exponent = __builtin_convertvector((bits >> 23) - 127, Aside);
  const auto m = (Aside)((bits & 0x007fffff) | 0x3f800000);  // 1 to 2
  // Least squares over that interval.
  return exponent +
         ((((-0.079158f * m + 0.628874f) * m + -2.081214f) * m + 4.028548f) * m + -2.496846f);
}

EMTR_INLINE Aside square_roots(const Aside& v) {
  float each[kAside];
  __builtin_memcpy(each, &v, sizeof each);
  for (float& value : each) value = __builtin_sqrtf(value);
  return load_aside(each);
}

void sampling_sums(const SamplingView& s, const float* at, double* out) {
  constexpr std::size_t parts = kLanes / kAside;
  Aside sum[parts] = {}, squares[parts] = {}, products[parts] = {};
  for (std::size_t i = 0; i < s.size; i += kLanes)
    for (std::size_t part = 0; part < parts; ++part) {
      const std::size_t k = i + part * kAside;
      const Aside dx = at[0] - load_aside(s.x + k), dy = at[1] - load_aside(s.y + k),
                  dz = at[2] - load_aside(s.z + k);
      const Aside squared = ((dx * dx + dy * dy) + dz * dz) + 1e-6f;
      const Aside dot =
          (dx * load_aside(s.nx + k) + dy * load_aside(s.ny + k)) + dz * load_aside(s.nz + k);
      const auto along = (Aside)((AsideInts)dot & 0x7fffffff);
      const Aside cosine = along / square_roots(squared) + kGrazing;
      const Aside predicted = load_aside(s.present + k) * approximate_log2(cosine / squared);
      sum[part] = sum[part] + predicted;
      squares[part] = squares[part] + predicted * predicted;
      products[part] = products[part] + predicted * load_aside(s.log_count + k);
    }
  out[0] = out[1] = out[2] = 0;
  for (std::size_t l = 0; l < kLanes; ++l) {
    out[0] += static_cast<double>(sum[l / kAside][l % kAside]);
    out[1] += static_cast<double>(squares[l / kAside][l % kAside]);
    out[2] += static_cast<double>(products[l / kAside][l % kAside]);
  }
}

}  // namespace
}  // namespace emtr::EMTR_KERNEL
