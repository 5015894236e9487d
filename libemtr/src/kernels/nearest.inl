// Nearest neighbors on a candidate grid. Included by each instruction set's file.
//
// The queries whose cells list candidates are looked up without a branch, whether a cell has one
// block of them or two, and with their buckets asked for ahead.

#include "kernels/occupied.inl"

namespace emtr::EMTR_KERNEL {
namespace {

constexpr std::size_t kTogether = 4;  // look-ups whose minima are taken at once

/// The blocks of a cell: `first`, then `begin` to `end`.
struct Bucket {
  std::uint32_t first, begin, end;
};

EMTR_INLINE Bucket bucket_of(const GridView& g, std::uint32_t cell) {
  const std::uint32_t k = rank_of(g.cells, cell);
  return {k, g.more[k], g.more[k + 1]};
}

EMTR_INLINE const float* block_at(const GridView& g, std::uint32_t block) {
  return g.blocks + std::size_t{block} * (3 * kLanes);
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
    store<kTogether, Floats>(out + k, least(least_of_each(best), all<kTogether>(g.cells.limit)));
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

void squared_distances(const GridView& g, const PointsView& queries, float* out) {
  Found found;
  float squared[kBatch + kTogether];
  for_each_batch(queries, [&](const PointsView& q, std::size_t first) {
    for (std::size_t i = 0; i < q.size; ++i) out[first + i] = g.cells.limit;
    sort_out(g.cells, q, found);
    look_up(g, q, found, squared);
    for (std::size_t k = 0; k < found.size; ++k) out[first + found.query[k]] = squared[k];
  });
}

void nearest(const GridView& g, const PointsView& queries, std::int32_t* candidate, float* out) {
  Found found;
  float squared[kBatch + kTogether];
  for_each_batch(queries, [&](const PointsView& q, std::size_t first) {
    for (std::size_t i = 0; i < q.size; ++i) {
      out[first + i] = g.cells.limit;
      candidate[first + i] = -1;
    }
    sort_out(g.cells, q, found);
    look_up(g, q, found, squared);
    for (std::size_t k = 0; k < found.size; ++k) {
      const std::size_t i = found.query[k];
      if (!(squared[k] < g.cells.limit)) continue;
      out[first + i] = squared[k];
      candidate[first + i] = candidate_at(g, found.cell[k], query_at(q, i), squared[k]);
    }
  });
}

}  // namespace
}  // namespace emtr::EMTR_KERNEL
