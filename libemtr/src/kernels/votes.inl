// Votes for translations. Included by each instruction set's file.

#include "kernels/lanes.h"
#include "kernels/search_kernels.h"

namespace emtr::EMTR_KERNEL {
namespace {

constexpr std::size_t kAtOnce = 16;  // pairs

/// Writes the cells of some pairs; `n` is a constant where it is kAtOnce.
EMTR_INLINE void cells_of_pairs(const VotePair* pairs, std::size_t n, const double* const source[2],
                                const double* const target[2], const VoteCells& g,
                                std::int32_t* out) {
  double at[2][kAtOnce];
  for (std::size_t l = 0; l < n; ++l)
    for (int a = 0; a < 2; ++a) at[a][l] = target[a][pairs[l].target] - source[a][pairs[l].source];
  std::int32_t cell[2][kAtOnce], inside[2][kAtOnce];
  for (int a = 0; a < 2; ++a)
    for (std::size_t l = 0; l < n; ++l) {
      const double where = (at[a][l] - g.reach) / g.cell;
      inside[a][l] = (where >= 0) & (where < static_cast<double>(g.cells));
      cell[a][l] = static_cast<std::int32_t>(where);
    }
  for (std::size_t l = 0; l < n; ++l)
    out[l] =
        inside[0][l] & inside[1][l] ? (cell[1][l] + 1) * g.row + cell[0][l] + 1 : g.row * g.row;
}

void vote(const VotePair* pairs, std::size_t n, const double* const source[2],
          const double* const target[2], const VoteCells& cells, std::int32_t* votes) {
  std::int32_t cell[kAtOnce];
  std::size_t i = 0;
  for (; i + kAtOnce <= n; i += kAtOnce) {
    cells_of_pairs(pairs + i, kAtOnce, source, target, cells, cell);
    for (const auto c : cell) ++votes[c];
  }
  cells_of_pairs(pairs + i, n - i, source, target, cells, cell);
  for (std::size_t l = 0; i + l < n; ++l) ++votes[cell[l]];
}

}  // namespace
}  // namespace emtr::EMTR_KERNEL
