// Nearest neighbours on a candidate grid. Included by each instruction set's file.

namespace emtr::EMTR_KERNEL {
namespace {

using Eight = Floats<kLanes>;

EMTR_INLINE float nearest_in_cell(const GridView& g, std::int32_t cell, float qx, float qy,
                                  float qz) {
  const std::uint32_t begin = g.begin[cell], end = g.begin[cell + 1];
  if (begin == end) return g.limit;
  const Eight px = all<kLanes>(qx), py = all<kLanes>(qy), pz = all<kLanes>(qz);
  Eight best = all<kLanes>(g.limit);
  for (std::uint32_t k = begin; k < end; k += kLanes) {
    const Eight dx = px - loaded<kLanes>(g.x + k);
    const Eight dy = py - loaded<kLanes>(g.y + k);
    const Eight dz = pz - loaded<kLanes>(g.z + k);
    best = least(best, (dx * dx + dy * dy) + dz * dz);
  }
  return least_of(best);
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
    at[a] = truncated(where);
  }
  const Ints<kLanes> cell =
      (at[2] * all<kLanes>(g.size[1]) + at[1]) * all<kLanes>(g.size[0]) + at[0];
  store<kLanes, Ints>(cells, (cell & inside) | ~inside);
}

void squared_distances(const GridView& g, const PointsView& q, float* out) {
  std::int32_t cells[kLanes];
  std::size_t i = 0;
  for (; i + kLanes <= q.size; i += kLanes) {
    cells_of(g, q.x + i, q.y + i, q.z + i, cells);
    for (std::size_t l = 0; l < kLanes; ++l)
      out[i + l] =
          cells[l] < 0 ? g.limit : nearest_in_cell(g, cells[l], q.x[i + l], q.y[i + l], q.z[i + l]);
  }
  if (i == q.size) return;
  float x[kLanes] = {}, y[kLanes] = {}, z[kLanes] = {};
  for (std::size_t l = 0; i + l < q.size; ++l) {
    x[l] = q.x[i + l];
    y[l] = q.y[i + l];
    z[l] = q.z[i + l];
  }
  cells_of(g, x, y, z, cells);
  for (std::size_t l = 0; i + l < q.size; ++l)
    out[i + l] = cells[l] < 0 ? g.limit : nearest_in_cell(g, cells[l], x[l], y[l], z[l]);
}

}  // namespace
}  // namespace emtr::EMTR_KERNEL
