// Computes the pairwise consistency of correspondences. Included by each instruction set's file.

#include "kernels/lanes.h"

#if defined(__AVX2__)
#include <immintrin.h>
#endif

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
      word |= std::uint64_t{bits_of(close)} << k;
    }
    bits[from / 64] = word;
  }
}

#if defined(__AVX2__)
constexpr std::size_t kWords = 4;       // in a register
constexpr std::size_t kMostBytes = 31;  // additions of up to 8 that a byte holds

/// Counts the bits that are set in both, words a multiple of kWords: those of each half byte are
/// read from a table, and the bytes summed up.
EMTR_INLINE std::size_t count_common_wide(const std::uint64_t* a, const std::uint64_t* b,
                                          std::size_t words) {
  const __m256i low = _mm256_set1_epi8(15);
  const __m256i table = _mm256_setr_epi8(0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4,  //
                                         0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4);
  __m256i sum = _mm256_setzero_si256();
  for (std::size_t i = 0; i < words;) {
    const std::size_t end = words - i < kMostBytes * kWords ? words : i + kMostBytes * kWords;
    __m256i bytes = _mm256_setzero_si256();
    for (; i < end; i += kWords) {
      const __m256i both = _mm256_and_si256(_mm256_loadu_si256((const __m256i*)(a + i)),
                                            _mm256_loadu_si256((const __m256i*)(b + i)));
      const __m256i high = _mm256_and_si256(_mm256_srli_epi16(both, 4), low);
      bytes = _mm256_add_epi8(bytes, _mm256_shuffle_epi8(table, _mm256_and_si256(both, low)));
      bytes = _mm256_add_epi8(bytes, _mm256_shuffle_epi8(table, high));
    }
    sum = _mm256_add_epi64(sum, _mm256_sad_epu8(bytes, _mm256_setzero_si256()));
  }
  std::uint64_t each[kWords];
  __builtin_memcpy(each, &sum, sizeof each);
  return (each[0] + each[1]) + (each[2] + each[3]);
}
#endif

std::size_t count_common(const std::uint64_t* a, const std::uint64_t* b, std::size_t words) {
  std::size_t count = 0, i = 0;
#if defined(__AVX2__)
  i = words / kWords * kWords;
  count = count_common_wide(a, b, i);
#endif
  for (; i < words; ++i) count += static_cast<std::size_t>(__builtin_popcountll(a[i] & b[i]));
  return count;
}

}  // namespace
}  // namespace emtr::EMTR_KERNEL
