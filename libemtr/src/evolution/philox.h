#pragma once

#include <array>
#include <cstdint>

namespace emtr {

/// Philox4x64-10 (Salmon et al., "Parallel random numbers: as easy as 1, 2, 3", SC 2011): a block
/// of four random words that depends on nothing but its key and counter, so any thread can draw
/// any particle's numbers in any order.
inline std::array<std::uint64_t, 4> philox(std::array<std::uint64_t, 2> key,
                                           std::array<std::uint64_t, 4> counter) {
  const auto multiply = [](std::uint64_t a, std::uint64_t b, std::uint64_t& high) {
    __extension__ using Wide = unsigned __int128;
    const Wide product = static_cast<Wide>(a) * b;
    high = static_cast<std::uint64_t>(product >> 64);
    return static_cast<std::uint64_t>(product);
  };
  for (int round = 0; round < 10; ++round) {
    std::uint64_t high0, high1;
    const std::uint64_t low0 = multiply(0xD2E7470EE14C6C93ULL, counter[0], high0);
    const std::uint64_t low1 = multiply(0xCA5A826395121157ULL, counter[2], high1);
    counter = {high1 ^ counter[1] ^ key[0], low1, high0 ^ counter[3] ^ key[1], low0};
    key[0] += 0x9E3779B97F4A7C15ULL;
    key[1] += 0xBB67AE8584CAA73BULL;
  }
  return counter;
}

/// Returns a number in [0, 1) made of one word, with all 53 bits that a double holds.
inline double uniform(std::uint64_t word) { return static_cast<double>(word >> 11) * 0x1.0p-53; }

/// Who draws random numbers: the counter is (iteration, stream, particle, dimension).
enum class Stream : std::uint64_t { Alpha = 0, Beta = 1, Transfer = 2 };

inline std::array<std::uint64_t, 4> draw(std::uint64_t seed, std::uint64_t iteration, Stream stream,
                                         std::uint64_t particle, std::uint64_t dimension) {
  return philox({seed, 0}, {iteration, static_cast<std::uint64_t>(stream), particle, dimension});
}

}  // namespace emtr
