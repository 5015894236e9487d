// Counts the inliers of a seed's pose. Included by each instruction set's file.

#include "kernels/doubles.inl"
#include "kernels/search_kernels.h"

namespace emtr::EMTR_KERNEL {
namespace {

/// Returns a bit for each number below the limit.
EMTR_INLINE std::uint64_t bits_below(const Doubles& value, double limit) {
  const auto below = value < limit;
#if defined(__AVX__)
  return static_cast<std::uint64_t>(__builtin_ia32_movmskpd256((Doubles)below));
#elif defined(__SSE2__)
  return static_cast<std::uint64_t>(__builtin_ia32_movmskpd((Doubles)below));
#else
  std::uint64_t bits = 0;
  for (std::size_t l = 0; l < kDoubles; ++l) bits |= std::uint64_t{below[l] != 0} << l;
  return bits;
#endif
}

/// Returns the squared distances of some transformed points to their ends.
EMTR_INLINE Doubles squared_residuals(const PointsView& p, const PointsView& q, const double* m,
                                      std::size_t i) {
  const Doubles x = load_doubles(p.x + i), y = load_doubles(p.y + i), z = load_doubles(p.z + i);
  const Doubles dx = (((m[0] * x + m[1] * y) + m[2] * z) + m[3]) - load_doubles(q.x + i);
  const Doubles dy = (((m[4] * x + m[5] * y) + m[6] * z) + m[7]) - load_doubles(q.y + i);
  const Doubles dz = (((m[8] * x + m[9] * y) + m[10] * z) + m[11]) - load_doubles(q.z + i);
  return (dx * dx + dy * dy) + dz * dz;
}

std::size_t pose_inliers(const PointsView& p, const PointsView& q, const double* matrix,
                         double squared_threshold, std::uint64_t* bits) {
  std::size_t count = 0;
  for (std::size_t from = 0; from < p.size; from += 64) {
    std::uint64_t word = 0;
    for (std::size_t k = 0; k < 64; k += kDoubles)
      word |= bits_below(squared_residuals(p, q, matrix, from + k), squared_threshold) << k;
    if (p.size - from < 64) word &= (std::uint64_t{1} << (p.size - from)) - 1;
    bits[from / 64] = word;
    count += static_cast<std::size_t>(__builtin_popcountll(word));
  }
  return count;
}

}  // namespace
}  // namespace emtr::EMTR_KERNEL
