// Finds which cells of a candidate grid a point is a candidate of. Included by each instruction
// set's file.

#include "kernels/lanes.h"
#include "kernels/search_kernels.h"

namespace emtr::EMTR_KERNEL {
namespace {

/// Squared distances along one axis from a point to the nearest and the farthest place of each
/// cell that it may reach; far away after the last.
struct Reach {
  std::int32_t low, count;
  float *nearest, *farthest;
};

EMTR_INLINE std::int32_t cell_at(const ReachView& g, int axis, float place) {
  const std::int32_t cell = place > 0 ? static_cast<std::int32_t>(place) : 0;
  return cell < g.cells.size[axis] ? cell : g.cells.size[axis] - 1;
}

EMTR_INLINE void reach_along(const ReachView& g, int axis, float p, float span, Reach& out) {
  const float at = (p - g.cells.origin[axis]) * g.cells.inverse_cell;
  out.low = cell_at(g, axis, at - span);
  out.count = cell_at(g, axis, at + span) - out.low + 1;
  for (std::int32_t i = 0; i < out.count; ++i) {
    const auto c = static_cast<float>(out.low + i);
    const float low = c - g.margin - at, high = c + 1 + g.margin - at;
    const float beyond = low > -high ? low : -high;
    const float near = g.cell * (beyond > 0 ? beyond : 0.0f);
    const float far = g.cell * (-low > high ? -low : high);
    out.nearest[i] = near * near;
    out.farthest[i] = far * far;
  }
  for (std::size_t l = 0; l < kLanes; ++l)
    out.nearest[static_cast<std::size_t>(out.count) + l] =
        out.farthest[static_cast<std::size_t>(out.count) + l] = kFarAway;
}

/// Calls each(first cell, nearest along y and z, farthest along y and z, reach along x) for each
/// row of cells that a point reaches, point after point.
template <class Each>
EMTR_INLINE void for_each_row(const ReachView& g, const PointsView& points, float* room,
                              Each each) {
  const float span = g.radius * g.cells.inverse_cell + g.margin;
  const std::size_t part = reach_room(g) / 6;
  Reach r[3];
  for (std::size_t a = 0; a < 3; ++a) {
    r[a].nearest = room + 2 * a * part;
    r[a].farthest = r[a].nearest + part;
  }
  for (std::size_t n = 0; n < points.size; ++n) {
    reach_along(g, 0, points.x[n], span, r[0]);
    reach_along(g, 1, points.y[n], span, r[1]);
    reach_along(g, 2, points.z[n], span, r[2]);
    for (std::int32_t k = 0; k < r[2].count; ++k)
      for (std::int32_t j = 0; j < r[1].count; ++j) {
        const std::ptrdiff_t row = std::ptrdiff_t{r[2].low + k} * g.cells.size[1] + (r[1].low + j);
        each(n, static_cast<std::size_t>(row * g.cells.size[0] + r[0].low),
             r[1].nearest[j] + r[2].nearest[k], r[1].farthest[j] + r[2].farthest[k], r[0]);
      }
  }
}

void reach_bounds(const ReachView& g, const PointsView& points, float* room, float* bound) {
  for_each_row(
      g, points, room, [&](std::size_t, std::size_t cell, float, float far, const Reach& x) {
        if (far >= g.cells.limit) return;
        float* at = bound + cell;
        for (std::int32_t i = 0; i < x.count; i += kLanes)
          store<kLanes, Floats>(
              at + i,
              minimum(load<kLanes>(at + i), broadcast<kLanes>(far) + load<kLanes>(x.farthest + i)));
      });
}

/// Calls each(point, first of kLanes cells, mask) where any of the cells has the point as a
/// candidate.
template <class Each>
EMTR_INLINE void for_each_candidate(const ReachView& g, const PointsView& points, float* room,
                                    const float* bound, Each each) {
  const float most = g.cells.limit * 1.001f;  // all bounds are less
  for_each_row(
      g, points, room, [&](std::size_t n, std::size_t cell, float near, float, const Reach& x) {
        if (near > most) return;
        for (std::int32_t i = 0; i < x.count; i += kLanes) {
          const std::size_t first = cell + static_cast<std::size_t>(i);
          const Ints<kLanes> is_near =
              load<kLanes>(bound + first) >= broadcast<kLanes>(near) + load<kLanes>(x.nearest + i);
          each(n, first, is_near);
        }
      });
}

void count_candidates(const ReachView& g, const PointsView& points, float* room, const float* bound,
                      std::uint32_t* count) {
  for_each_candidate(g, points, room, bound,
                     [&](std::size_t, std::size_t first, const Ints<kLanes>& is_near) {
                       auto* at = reinterpret_cast<std::int32_t*>(count + first);
                       store<kLanes, Ints>(at, load_ints<kLanes>(at) - is_near);
                     });
}

void list_candidates(const ReachView& g, const PointsView& points, std::size_t first_point,
                     float* room, const float* bound, const CandidateLists& lists) {
  for_each_candidate(
      g, points, room, bound, [&](std::size_t n, std::size_t first, const Ints<kLanes>& is_near) {
        for (std::uint32_t left = bits_of(is_near); left != 0; left &= left - 1) {
          const std::size_t cell = first + static_cast<std::size_t>(__builtin_ctz(left));
          const std::uint32_t place = lists.place[cell], rank = lists.filled[place]++;
          const std::size_t lane = rank % kLanes,
                            block = rank < kLanes ? place : lists.more[place] + rank / kLanes - 1;
          float* at = lists.blocks + block * (3 * kLanes) + lane;
          at[0] = points.x[n];
          at[kLanes] = points.y[n];
          at[2 * kLanes] = points.z[n];
          lists.index[block * kLanes + lane] = static_cast<std::int32_t>(first_point + n);
        }
      });
}

}  // namespace
}  // namespace emtr::EMTR_KERNEL
