// Finds the queries in cells that have points near. Included by each instruction set's file.
//
// Most queries of a random pose have nothing near. The bits of the cells tell so and fit into the
// nearest cache, so a batch is filtered first, without a branch.

#pragma once

#include "kernels/lanes.h"

#if EMTR_REGISTER == 16
#include <immintrin.h>
#endif

namespace emtr::EMTR_KERNEL {
namespace {

constexpr std::size_t kBatch = 256;

/// The queries of a batch whose cells list candidates.
struct Found {
  std::uint32_t query[kBatch + kWide], cell[kBatch + kWide];
  std::size_t size;
};

/// Returns the cell of each of sixteen queries.
EMTR_INLINE Ints<kWide> cells_of(const CellsView& g, const float* x, const float* y,
                                 const float* z) {
  const float* query[3] = {x, y, z};
  Ints<kWide> at[3];
  for (int a = 0; a < 3; ++a) {
    const Sixteen where =
        (load<kWide>(query[a]) - broadcast<kWide>(g.origin[a])) * broadcast<kWide>(g.inverse_cell);
    at[a] = truncated(minimum(maximum(where, broadcast<kWide>(0.0f)),
                              broadcast<kWide>(static_cast<float>(g.size[a] - 1))));
  }
  return (at[2] * broadcast<kWide>(g.size[1]) + at[1]) * broadcast<kWide>(g.size[0]) + at[0];
}

/// Adds those of the `n` queries from `first` on, sixteen at most, whose cells are occupied.
EMTR_INLINE void add_occupied(const CellsView& g, const Ints<kWide>& cells, std::size_t first,
                              std::size_t n, Found& found) {
#if EMTR_REGISTER == 16
  // Passes sources that nothing needs: without them the compiler warns of its own header.
  using Int = Register<kWide>::Int;
  const Int lane = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
  const __m512i c = (__m512i)cells.v, query = (__m512i)(lane + static_cast<std::int32_t>(first));
  const __m512i occupied = _mm512_mask_i32gather_epi32(
      _mm512_setzero_si512(), 0xffff, (__m512i)(cells.v >> 5), g.groups, sizeof(CellGroup));
  const auto valid = static_cast<__mmask16>((1u << n) - 1);
  const __mmask16 set =
      _mm512_mask_test_epi32_mask(valid, occupied, (__m512i)((Int{} + 1) << (cells.v & 31)));
  _mm512_storeu_si512(found.query + found.size, _mm512_maskz_compress_epi32(set, query));
  _mm512_storeu_si512(found.cell + found.size, _mm512_maskz_compress_epi32(set, c));
  found.size += static_cast<std::size_t>(__builtin_popcount(set));
#else
  std::uint32_t each[kWide];
  store<kWide, Ints>(each, cells);
  std::size_t size = found.size;
  for (std::size_t l = 0; l < n; ++l) {
    const std::uint32_t c = each[l];
    found.query[size] = static_cast<std::uint32_t>(first + l);
    found.cell[size] = c;
    size += (g.groups[c / 32].occupied >> (c % 32)) & 1;
  }
  found.size = size;
#endif
}

EMTR_INLINE void find_occupied(const CellsView& g, const PointsView& q, Found& found) {
  found.size = 0;
  std::size_t i = 0;
  for (; i + kWide <= q.size; i += kWide)
    add_occupied(g, cells_of(g, q.x + i, q.y + i, q.z + i), i, kWide, found);
  if (i == q.size) return;
  float rest[3][kWide] = {};
  for (std::size_t l = 0; i + l < q.size; ++l) {
    rest[0][l] = q.x[i + l];
    rest[1][l] = q.y[i + l];
    rest[2][l] = q.z[i + l];
  }
  add_occupied(g, cells_of(g, rest[0], rest[1], rest[2]), i, q.size - i, found);
}

/// Returns the place of an occupied cell among all of them.
EMTR_INLINE std::uint32_t rank_of(const CellsView& g, std::uint32_t cell) {
  const CellGroup group = g.groups[cell / 32];
  const std::uint32_t from = group.occupied << (31 - cell % 32);  // this cell and those below
  return group.before + static_cast<std::uint32_t>(__builtin_popcount(from)) - 1;
}

struct Query {
  Eight x, y, z;
};

EMTR_INLINE Query query_at(const PointsView& q, std::size_t i) {
  return {broadcast<kLanes>(q.x[i]), broadcast<kLanes>(q.y[i]), broadcast<kLanes>(q.z[i])};
}

/// Calls each(batch, its first query) for batch after batch.
template <class Each>
EMTR_INLINE void for_each_batch(const PointsView& q, Each each) {
  for (std::size_t i = 0; i < q.size; i += kBatch)
    each(PointsView{q.x + i, q.y + i, q.z + i, q.size - i < kBatch ? q.size - i : kBatch}, i);
}

}  // namespace
}  // namespace emtr::EMTR_KERNEL
