// Nearest neighbours on a candidate grid. Included by each instruction set's file.
//
// Most queries of a random pose have nothing near, which the bits of the cells tell, and they are
// few enough for the nearest cache. So a batch is sorted out first, without a branch; the look-ups
// proper then run without one too, whether a cell has one block of candidates or two.

#include "lanes.h"

#if EMTR_REGISTER == 16
#include <immintrin.h>
#endif

namespace emtr::EMTR_KERNEL {
namespace {

constexpr std::size_t kBatch = 256;
constexpr std::size_t kTogether = 4;  // look-ups whose minima are taken at once

/// Those queries of a batch whose cells list candidates.
struct Found {
  std::uint32_t query[kBatch + kWide], cell[kBatch + kWide];
  std::size_t size;
};

/// The cell of each of sixteen queries.
EMTR_INLINE Ints<kWide> cells_of(const GridView& g, const float* x, const float* y,
                                 const float* z) {
  const float* query[3] = {x, y, z};
  Ints<kWide> at[3];
  for (int a = 0; a < 3; ++a) {
    const Sixteen where =
        (loaded<kWide>(query[a]) - all<kWide>(g.origin[a])) * all<kWide>(g.inverse_cell);
    at[a] = truncated(
        least(most(where, all<kWide>(0.0f)), all<kWide>(static_cast<float>(g.size[a] - 1))));
  }
  return (at[2] * all<kWide>(g.size[1]) + at[1]) * all<kWide>(g.size[0]) + at[0];
}

/// Adds those of the `n` queries from `first` on, sixteen at most, whose cells are occupied.
EMTR_INLINE void add_occupied(const GridView& g, const Ints<kWide>& cells, std::size_t first,
                              std::size_t n, Found& found) {
#if EMTR_REGISTER == 16
  // Sources are given where none is needed: without, the compiler warns of its own header.
  using Int = Register<kWide>::Int;
  const Int lane = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
  const __m512i c = (__m512i)cells.v, query = (__m512i)(lane + static_cast<std::int32_t>(first));
  const __m512i occupied = _mm512_mask_i32gather_epi32(
      _mm512_setzero_si512(), 0xffff, (__m512i)(cells.v >> 5), g.groups, sizeof(CellGroup));
  const __mmask16 asked = static_cast<__mmask16>((1u << n) - 1);
  const __mmask16 set =
      _mm512_mask_test_epi32_mask(asked, occupied, (__m512i)((Int{} + 1) << (cells.v & 31)));
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

EMTR_INLINE void sort_out(const GridView& g, const PointsView& q, Found& found) {
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

/// The blocks of a cell: `first`, then `begin` to `end`.
struct Bucket {
  std::uint32_t first, begin, end;
};

EMTR_INLINE Bucket bucket_of(const GridView& g, std::uint32_t cell) {
  const CellGroup group = g.groups[cell / 32];
  const std::uint32_t from = group.occupied << (31 - cell % 32);  // this cell and those below
  const std::uint32_t k = group.before + static_cast<std::uint32_t>(__builtin_popcount(from)) - 1;
  return {k, g.more[k], g.more[k + 1]};
}

EMTR_INLINE const float* block_at(const GridView& g, std::uint32_t block) {
  return g.blocks + std::size_t{block} * (3 * kLanes);
}

struct Query {
  Eight x, y, z;
};

EMTR_INLINE Query query_at(const PointsView& q, std::size_t i) {
  return {all<kLanes>(q.x[i]), all<kLanes>(q.y[i]), all<kLanes>(q.z[i])};
}

/// Squared distances of a query to the eight candidates of a block.
EMTR_INLINE Eight to_candidates(const GridView& g, std::uint32_t block, const Query& q) {
  const float* at = block_at(g, block);
  const Eight dx = q.x - loaded<kLanes>(at);
  const Eight dy = q.y - loaded<kLanes>(at + kLanes);
  const Eight dz = q.z - loaded<kLanes>(at + 2 * kLanes);
  return (dx * dx + dy * dy) + dz * dz;
}

/// In any lane the nearest of some candidates, in one the nearest of all.
EMTR_INLINE Eight nearest_in(const GridView& g, const Bucket& bucket, const Query& q) {
  const std::uint32_t second = bucket.begin < bucket.end ? bucket.begin : bucket.first;
  Eight best = least(to_candidates(g, bucket.first, q), to_candidates(g, second, q));
  for (std::uint32_t b = bucket.begin + 1; __builtin_expect(b < bucket.end, 0); ++b)
    best = least(best, to_candidates(g, b, q));
  return best;
}

/// Where the candidates of each query found are, asked for before they are needed.
EMTR_INLINE void find_buckets(const GridView& g, const Found& found, Bucket* buckets) {
  for (std::size_t k = 0; k < found.size; ++k) {
    buckets[k] = bucket_of(g, found.cell[k]);
    const float* at = block_at(g, buckets[k].first);
    __builtin_prefetch(at);
    __builtin_prefetch(at + 3 * kLanes - 1);
  }
}

/// out[k] = squared distance of the k-th query found, at most the limit.
EMTR_INLINE void look_up(const GridView& g, const PointsView& q, Found& found, float* out) {
  if (found.size == 0) return;
  Bucket buckets[kBatch + kTogether];
  find_buckets(g, found, buckets);
  // The last ones are made up to a full set by looking one up again.
  for (std::size_t k = 0; k < kTogether; ++k) {
    found.query[found.size + k] = found.query[0];
    buckets[found.size + k] = buckets[0];
  }
  for (std::size_t k = 0; k < found.size; k += kTogether) {
    Eight best[kTogether];
    for (std::size_t l = 0; l < kTogether; ++l)
      best[l] = nearest_in(g, buckets[k + l], query_at(q, found.query[k + l]));
    store<kTogether, Floats>(out + k, least(least_of_each(best), all<kTogether>(g.limit)));
  }
}

/// The first candidate of a cell at exactly this distance, which one has.
EMTR_INLINE std::int32_t candidate_at(const GridView& g, std::uint32_t cell, const Query& q,
                                      float squared) {
  const Bucket bucket = bucket_of(g, cell);
  float each[kLanes];
  for (std::uint32_t block = bucket.first, next = bucket.begin;; block = next++) {
    store<kLanes, Floats>(each, to_candidates(g, block, q));
    for (std::uint32_t l = 0; l < kLanes; ++l)
      if (each[l] == squared) return static_cast<std::int32_t>(block * kLanes + l);
  }
}

/// Calls each(batch, its first query) for batch after batch.
template <class Each>
EMTR_INLINE void for_each_batch(const PointsView& q, Each each) {
  for (std::size_t i = 0; i < q.size; i += kBatch)
    each(PointsView{q.x + i, q.y + i, q.z + i, q.size - i < kBatch ? q.size - i : kBatch}, i);
}

void squared_distances(const GridView& g, const PointsView& queries, float* out) {
  Found found;
  float squared[kBatch + kTogether];
  for_each_batch(queries, [&](const PointsView& q, std::size_t first) {
    for (std::size_t i = 0; i < q.size; ++i) out[first + i] = g.limit;
    sort_out(g, q, found);
    look_up(g, q, found, squared);
    for (std::size_t k = 0; k < found.size; ++k) out[first + found.query[k]] = squared[k];
  });
}

void nearest(const GridView& g, const PointsView& queries, std::int32_t* candidate, float* out) {
  Found found;
  float squared[kBatch + kTogether];
  for_each_batch(queries, [&](const PointsView& q, std::size_t first) {
    for (std::size_t i = 0; i < q.size; ++i) {
      out[first + i] = g.limit;
      candidate[first + i] = -1;
    }
    sort_out(g, q, found);
    look_up(g, q, found, squared);
    for (std::size_t k = 0; k < found.size; ++k) {
      const std::size_t i = found.query[k];
      if (!(squared[k] < g.limit)) continue;
      out[first + i] = squared[k];
      candidate[first + i] = candidate_at(g, found.cell[k], query_at(q, i), squared[k]);
    }
  });
}

}  // namespace
}  // namespace emtr::EMTR_KERNEL
