// Finds nearest neighbors among the points of the cells around a query. Included by each
// instruction set's file.

#include "kernels/occupied.inl"

namespace emtr::EMTR_KERNEL {
namespace {

/// Returns the squared distances of a query to the eight points from `at` on.
EMTR_INLINE Eight to_points(const VoxelView& v, std::uint32_t at, const Query& q) {
  const Eight dx = q.x - load<kLanes>(v.x + at);
  const Eight dy = q.y - load<kLanes>(v.y + at);
  const Eight dz = q.z - load<kLanes>(v.z + at);
  return (dx * dx + dy * dy) + dz * dz;
}

/// The ranges of starts of the queries found.
struct Ranges {
  std::uint32_t begin[kBatch], end[kBatch];
};

/// Finds and prefetches the ranges.
EMTR_INLINE void find_ranges(const VoxelView& v, const Found& found, Ranges& ranges) {
  for (std::size_t k = 0; k < found.size; ++k) {
    const std::uint32_t rank = rank_of(v.cells, found.cell[k]);
    ranges.begin[k] = v.begin[rank];
    ranges.end[k] = v.begin[rank + 1];
    __builtin_prefetch(v.starts + ranges.begin[k]);
  }
}

EMTR_INLINE float nearest_in(const VoxelView& v, std::uint32_t begin, std::uint32_t end,
                             const Query& q) {
  Eight best = broadcast<kLanes>(v.cells.limit);
  for (std::uint32_t k = begin; k < end; ++k) best = minimum(best, to_points(v, v.starts[k], q));
  return minimum_of(best);
}

/// Returns the smallest row of the points at exactly this distance.
EMTR_INLINE std::int32_t row_at(const VoxelView& v, std::uint32_t begin, std::uint32_t end,
                                const Query& q, float squared) {
  std::int32_t row = INT32_MAX;
  const Eight nearest = broadcast<kLanes>(squared);  // no point is nearer
  for (std::uint32_t k = begin; k < end; ++k)
    for (std::uint32_t left = bits_of(nearest >= to_points(v, v.starts[k], q)); left != 0;
         left &= left - 1) {
      const std::int32_t here =
          v.index[v.starts[k] + static_cast<std::uint32_t>(__builtin_ctz(left))];
      if (here < row) row = here;
    }
  return row;
}

void voxel_squared_distances(const VoxelView& v, const PointsView& queries, float* out) {
  Found found;
  Ranges ranges;
  for_each_batch(queries, [&](const PointsView& q, std::size_t first) {
    for (std::size_t i = 0; i < q.size; ++i) out[first + i] = v.cells.limit;
    find_occupied(v.cells, q, found);
    find_ranges(v, found, ranges);
    for (std::size_t k = 0; k < found.size; ++k)
      out[first + found.query[k]] =
          nearest_in(v, ranges.begin[k], ranges.end[k], query_at(q, found.query[k]));
  });
}

void voxel_nearest(const VoxelView& v, const PointsView& queries, std::int32_t* index, float* out) {
  Found found;
  Ranges ranges;
  for_each_batch(queries, [&](const PointsView& q, std::size_t first) {
    for (std::size_t i = 0; i < q.size; ++i) {
      out[first + i] = v.cells.limit;
      index[first + i] = -1;
    }
    find_occupied(v.cells, q, found);
    find_ranges(v, found, ranges);
    for (std::size_t k = 0; k < found.size; ++k) {
      const std::size_t i = found.query[k];
      const Query query = query_at(q, i);
      const float squared = nearest_in(v, ranges.begin[k], ranges.end[k], query);
      if (!(squared < v.cells.limit)) continue;
      out[first + i] = squared;
      index[first + i] = row_at(v, ranges.begin[k], ranges.end[k], query, squared);
    }
  });
}

}  // namespace
}  // namespace emtr::EMTR_KERNEL
