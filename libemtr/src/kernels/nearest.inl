// Nearest neighbours on a candidate grid. Included by each instruction set's file.

#include "lanes.h"

namespace emtr::EMTR_KERNEL {
namespace {

/// Squared distances of a query to the eight candidates from k on.
EMTR_INLINE Eight to_candidates(const GridView& g, std::uint32_t k, const Eight& x, const Eight& y,
                                const Eight& z) {
  const Eight dx = x - loaded<kLanes>(g.x + k);
  const Eight dy = y - loaded<kLanes>(g.y + k);
  const Eight dz = z - loaded<kLanes>(g.z + k);
  return (dx * dx + dy * dy) + dz * dz;
}

EMTR_INLINE float nearest_in_cell(const GridView& g, std::int32_t cell, float qx, float qy,
                                  float qz) {
  const std::uint32_t begin = g.begin[cell], end = g.begin[cell + 1];
  if (begin == end) return g.limit;
  const Eight x = all<kLanes>(qx), y = all<kLanes>(qy), z = all<kLanes>(qz);
  Eight best = all<kLanes>(g.limit);
  for (std::uint32_t k = begin; k < end; k += kLanes)
    best = least(best, to_candidates(g, k, x, y, z));
  return least_of(best);
}

/// The first candidate of a cell at exactly this distance, which one has.
EMTR_INLINE std::int32_t candidate_at(const GridView& g, std::int32_t cell, float qx, float qy,
                                      float qz, float squared) {
  const Eight x = all<kLanes>(qx), y = all<kLanes>(qy), z = all<kLanes>(qz);
  float each[kLanes];
  for (std::uint32_t k = g.begin[cell];; k += kLanes) {
    store<kLanes, Floats>(each, to_candidates(g, k, x, y, z));
    for (std::uint32_t l = 0; l < kLanes; ++l)
      if (each[l] == squared) return static_cast<std::int32_t>(k + l);
  }
}

/// The cell of each of eight queries, negative outside the grid.
EMTR_INLINE void cells_of(const GridView& g, const float* x, const float* y, const float* z,
                          std::int32_t* cells) {
  const float* query[3] = {x, y, z};
  Ints<kLanes> inside, at[3];
  for (int a = 0; a < 3; ++a) {
    const Eight where =
        (loaded<kLanes>(query[a]) - all<kLanes>(g.origin[a])) * all<kLanes>(g.inverse_cell);
    const Ints<kLanes> here =
        (where >= all<kLanes>(0.0f)) & (where < all<kLanes>(static_cast<float>(g.size[a])));
    inside = a == 0 ? here : inside & here;
    at[a] = truncated(masked(where, here));
  }
  const Ints<kLanes> cell =
      (at[2] * all<kLanes>(g.size[1]) + at[1]) * all<kLanes>(g.size[0]) + at[0];
  store<kLanes, Ints>(cells, (cell & inside) | ~inside);
}

/// Calls found(i, cell, x, y, z) for each query that lies in the grid, and outside(i) for the rest.
template <class Found, class Outside>
EMTR_INLINE void for_each_query(const GridView& g, const PointsView& q, Found found,
                                Outside outside) {
  std::int32_t cells[kLanes];
  for (std::size_t i = 0; i < q.size; i += kLanes) {
    const std::size_t n = q.size - i < kLanes ? q.size - i : kLanes;
    if (n == kLanes) {
      cells_of(g, q.x + i, q.y + i, q.z + i, cells);
    } else {
      float x[kLanes] = {}, y[kLanes] = {}, z[kLanes] = {};
      for (std::size_t l = 0; l < n; ++l) {
        x[l] = q.x[i + l];
        y[l] = q.y[i + l];
        z[l] = q.z[i + l];
      }
      cells_of(g, x, y, z, cells);
    }
    for (std::size_t l = 0; l < n; ++l)
      if (cells[l] < 0)
        outside(i + l);
      else
        found(i + l, cells[l], q.x[i + l], q.y[i + l], q.z[i + l]);
  }
}

void squared_distances(const GridView& g, const PointsView& q, float* out) {
  for_each_query(
      g, q,
      [&](std::size_t i, std::int32_t cell, float x, float y, float z) {
        out[i] = nearest_in_cell(g, cell, x, y, z);
      },
      [&](std::size_t i) { out[i] = g.limit; });
}

void nearest(const GridView& g, const PointsView& q, std::int32_t* candidate, float* squared) {
  for_each_query(
      g, q,
      [&](std::size_t i, std::int32_t cell, float x, float y, float z) {
        squared[i] = nearest_in_cell(g, cell, x, y, z);
        candidate[i] = squared[i] < g.limit ? candidate_at(g, cell, x, y, z, squared[i]) : -1;
      },
      [&](std::size_t i) {
        squared[i] = g.limit;
        candidate[i] = -1;
      });
}

}  // namespace
}  // namespace emtr::EMTR_KERNEL
