// Finds nearest neighbors on a candidate grid. Included by each instruction set's file.
//
// Queries whose cells list candidates run without a branch, whether a cell has one block of them or
// two, and their buckets are prefetched.

#include "kernels/occupied.inl"

namespace emtr::EMTR_KERNEL {
namespace {

constexpr std::size_t kQueriesAtOnce = 4;  // queries whose minima are taken at once

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

/// Returns the squared distances of a query to the eight candidates of a block.
EMTR_INLINE Eight to_candidates(const GridView& g, std::uint32_t block, const Query& q) {
  const float* at = block_at(g, block);
  const Eight dx = q.x - load<kLanes>(at);
  const Eight dy = q.y - load<kLanes>(at + kLanes);
  const Eight dz = q.z - load<kLanes>(at + 2 * kLanes);
  return (dx * dx + dy * dy) + dz * dz;
}

/// Returns in each lane the nearest of some candidates; the minimum of the lanes is the nearest of
/// all.
EMTR_INLINE Eight nearest_in(const GridView& g, const Bucket& bucket, const Query& q) {
  const std::uint32_t second = bucket.begin < bucket.end ? bucket.begin : bucket.first;
  Eight best = minimum(to_candidates(g, bucket.first, q), to_candidates(g, second, q));
  for (std::uint32_t b = bucket.begin + 1; __builtin_expect(b < bucket.end, 0); ++b)
    best = minimum(best, to_candidates(g, b, q));
  return best;
}

/// Finds and prefetches the candidates of each query.
EMTR_INLINE void find_buckets(const GridView& g, const Found& found, Bucket* buckets) {
  for (std::size_t k = 0; k < found.size; ++k) {
    buckets[k] = bucket_of(g, found.cell[k]);
    const float* at = block_at(g, buckets[k].first);
    __builtin_prefetch(at);
    __builtin_prefetch(at + 3 * kLanes - 1);
  }
}

/// Writes the bucket of the k-th query found, and out[k] = its squared distance, at most the limit.
EMTR_INLINE void query_squared_distances(const GridView& g, const PointsView& q, Found& found,
                                         Bucket* buckets, float* out) {
  if (found.size == 0) return;
  find_buckets(g, found, buckets);
  // Fills the last set up by repeating a query.
  for (std::size_t k = 0; k < kQueriesAtOnce; ++k) {
    found.query[found.size + k] = found.query[0];
    buckets[found.size + k] = buckets[0];
  }
  for (std::size_t k = 0; k < found.size; k += kQueriesAtOnce) {
    Eight best[kQueriesAtOnce];
    for (std::size_t l = 0; l < kQueriesAtOnce; ++l)
      best[l] = nearest_in(g, buckets[k + l], query_at(q, found.query[k + l]));
    store<kQueriesAtOnce, Floats>(
        out + k, minimum(minimum_of_each(best), broadcast<kQueriesAtOnce>(g.cells.limit)));
  }
}

/// Returns a bit for each candidate of a block that is at this distance; none is nearer.
EMTR_INLINE std::uint32_t bits_at(const GridView& g, std::uint32_t block, const Query& q,
                                  const Eight& squared) {
  return bits_of(squared >= to_candidates(g, block, q));
}

/// Returns the first candidate of a bucket at exactly this distance; there is one.
EMTR_INLINE std::int32_t candidate_at(const GridView& g, const Bucket& bucket, const Query& q,
                                      float squared) {
  const Eight nearest = broadcast<kLanes>(squared);
  std::uint32_t blocks[2] = {bucket.first, bucket.begin < bucket.end ? bucket.begin : bucket.first};
  std::uint32_t at = bits_at(g, blocks[0], q, nearest) | bits_at(g, blocks[1], q, nearest)
                                                             << kLanes;
  for (std::uint32_t b = bucket.begin + 1; __builtin_expect(at == 0, 0); ++b) {
    blocks[0] = b;
    at = bits_at(g, b, q, nearest);
  }
  const auto place = static_cast<std::uint32_t>(__builtin_ctz(at));
  return static_cast<std::int32_t>(blocks[place / kLanes] * kLanes + place % kLanes);
}

void squared_distances(const GridView& g, const PointsView& queries, float* out) {
  Found found;
  Bucket buckets[kBatch + kQueriesAtOnce];
  float squared[kBatch + kQueriesAtOnce];
  for_each_batch(queries, [&](const PointsView& q, std::size_t first) {
    for (std::size_t i = 0; i < q.size; ++i) out[first + i] = g.cells.limit;
    find_occupied(g.cells, q, found);
    query_squared_distances(g, q, found, buckets, squared);
    for (std::size_t k = 0; k < found.size; ++k) out[first + found.query[k]] = squared[k];
  });
}

void nearest(const GridView& g, const PointsView& queries, std::int32_t* candidate, float* out) {
  Found found;
  Bucket buckets[kBatch + kQueriesAtOnce];
  float squared[kBatch + kQueriesAtOnce];
  for_each_batch(queries, [&](const PointsView& q, std::size_t first) {
    for (std::size_t i = 0; i < q.size; ++i) {
      out[first + i] = g.cells.limit;
      candidate[first + i] = -1;
    }
    find_occupied(g.cells, q, found);
    query_squared_distances(g, q, found, buckets, squared);
    for (std::size_t k = 0; k < found.size; ++k) {
      const std::size_t i = found.query[k];
      if (!(squared[k] < g.cells.limit)) continue;
      out[first + i] = squared[k];
      candidate[first + i] = candidate_at(g, buckets[k], query_at(q, i), squared[k]);
    }
  });
}

}  // namespace
}  // namespace emtr::EMTR_KERNEL
