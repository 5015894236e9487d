// Computes the pairwise consistency of correspondences. Included by each instruction set's file.

#include "kernels/lanes.h"

namespace emtr::EMTR_KERNEL {
namespace {

EMTR_INLINE Sixteen lengths(const PointsView& p, std::size_t i, std::size_t from) {
  const Sixteen dx = load<kWide>(p.x + from) - broadcast<kWide>(p.x[i]);
  const Sixteen dy = load<kWide>(p.y + from) - broadcast<kWide>(p.y[i]);
  const Sixteen dz = load<kWide>(p.z + from) - broadcast<kWide>(p.z[i]);
  return root((dx * dx + dy * dy) + dz * dz);
}

void consistent(const PointsView& p, const PointsView& q, std::size_t i, float threshold,
                std::uint64_t* bits) {
  for (std::size_t from = 0; from < p.size; from += 64) {
    std::uint64_t word = 0;
    for (std::size_t k = 0; k < 64; k += kWide) {
      const Sixteen d = lengths(p, i, from + k) - lengths(q, i, from + k);
      const Ints<kWide> close =
          (d < broadcast<kWide>(threshold)) & (broadcast<kWide>(-threshold) < d);
      std::int32_t each[kWide];
      store<kWide, Ints>(each, close);
      for (std::size_t l = 0; l < kWide; ++l)
        word |= static_cast<std::uint64_t>(each[l] & 1) << (k + l);
    }
    bits[from / 64] = word;
  }
}

std::size_t count_common(const std::uint64_t* a, const std::uint64_t* b, std::size_t words) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < words; ++i)
    count += static_cast<std::size_t>(__builtin_popcountll(a[i] & b[i]));
  return count;
}

}  // namespace
}  // namespace emtr::EMTR_KERNEL
