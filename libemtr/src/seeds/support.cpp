#include "seeds/support.h"

#include <cstdint>

namespace emtr {

// The support is twice the number of a correspondence's triangles i < k < j of consistent ones. Of
// these the sides i, j and k, j each have one more end below j in common. So it is enough to count
// what lies below j: twice for i and k, and once for j, which has both sides.
std::vector<std::size_t> support_of_each(const Consistency& c, ThreadTeam& team) {
  std::vector<std::vector<std::size_t>> parts(team.size());  // by thread
  // Rows in blocks of one word, which stay in the cache while the others pass.
  team.parallel(c.words(), [&](std::size_t word, std::size_t thread) {
    std::vector<std::size_t>& sums = parts[thread];
    sums.resize(c.size());
    for (std::size_t j = 64 * word + 1; j < c.size(); ++j) {
      check_cancelled_each(j, 8);
      std::uint64_t bits = c.row(j)[word];
      if (j / 64 == word) bits &= (std::uint64_t{1} << (j % 64)) - 1;
      for (; bits; bits &= bits - 1) {
        const std::size_t i = 64 * word + static_cast<std::size_t>(__builtin_ctzll(bits)),
                          common = c.common_before(i, j);
        sums[i] += 2 * common;
        sums[j] += common;
      }
    }
  });
  std::vector<std::size_t> out(c.size());
  for (const std::vector<std::size_t>& sums : parts)
    for (std::size_t i = 0; i < sums.size(); ++i) out[i] += sums[i];
  return out;
}

}  // namespace emtr
