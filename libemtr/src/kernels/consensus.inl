// Sums task beta over all pairs of correspondences. Included by each instruction set's file.
//
// The residual of the pair j, k is a difference of two ends: with e = R p - q of a correspondence,
// R (p_k - p_j) - (q_k - q_j) = e_k - e_j. So the sum is over the pairs of a few hundred points,
// which stay in the nearest cache, and it skips pairs of blocks that lie apart.

#include "kernels/lanes.h"

namespace emtr::EMTR_KERNEL {
namespace {

/// Ends in blocks of sixteen and the boxes around them.
struct Ends {
  const float* at[3];
  const float *low[3], *high[3];  // of each block
  std::size_t size, blocks;
};

Ends make_ends(const PointsView& p, const PointsView& q, const float* R, float* room) {
  Ends ends = {{}, {}, {}, p.size, (p.size + kWide - 1) / kWide};
  const std::size_t padded = ends.blocks * kWide;
  const float* to[3] = {q.x, q.y, q.z};
  for (std::size_t a = 0; a < 3; ++a) {
    float *at = room, *low = room + padded, *high = low + ends.blocks;
    for (std::size_t i = 0; i < p.size; ++i)
      at[i] = ((R[3 * a] * p.x[i] + R[3 * a + 1] * p.y[i]) + R[3 * a + 2] * p.z[i]) - to[a][i];
    for (std::size_t i = p.size; i < padded; ++i) at[i] = at[p.size - 1];
    for (std::size_t b = 0; b < ends.blocks; ++b) {
      const Sixteen block = load<kWide>(at + b * kWide);
      low[b] = minimum_of(block);
      high[b] = -minimum_of(Sixteen{} - block);
    }
    for (std::size_t i = p.size; i < padded; ++i) at[i] = kFarAway;
    ends.at[a] = at;
    ends.low[a] = low;
    ends.high[a] = high;
    room = high + ends.blocks;
  }
  return ends;
}

/// Returns a lower bound of the squared residuals of the pairs of two blocks, exact to the last
/// bit: the operations are the same, and rounding keeps the order of their results.
EMTR_INLINE float squared_gap(const Ends& ends, std::size_t i, std::size_t j) {
  float squared[3];
  for (int a = 0; a < 3; ++a) {
    const float below = ends.low[a][i] - ends.high[a][j], above = ends.low[a][j] - ends.high[a][i];
    const float gap = below > above ? below : above;
    squared[a] = gap > 0 ? gap * gap : 0;
  }
  return (squared[0] + squared[1]) + squared[2];
}

struct Sums {
  Ints<kWide> count;
  double residuals[kWide];
};

/// Adds the pairs of one end of block i and one of block j; with Same, where i is j, each pair
/// once.
template <bool Same>
EMTR_INLINE void add_pairs(const Ends& ends, std::size_t i, std::size_t j, float squared_threshold,
                           Sums& sums) {
  const float *at_x = ends.at[0], *at_y = ends.at[1], *at_z = ends.at[2];
  const Sixteen x = load<kWide>(at_x + j * kWide);
  const Sixteen y = load<kWide>(at_y + j * kWide);
  const Sixteen z = load<kWide>(at_z + j * kWide);
  const std::size_t begin = i * kWide, left = ends.size - begin, n = left < kWide ? left : kWide;
  Sixteen sum = {};
  Ints<kWide> count = {};
  for (std::size_t k = 0; k < n; ++k) {
    const Sixteen dx = x - broadcast<kWide>(at_x[begin + k]);
    const Sixteen dy = y - broadcast<kWide>(at_y[begin + k]);
    const Sixteen dz = z - broadcast<kWide>(at_z[begin + k]);
    const Sixteen squared = (dx * dx + dy * dy) + dz * dz;
    Ints<kWide> inlier = squared < broadcast<kWide>(squared_threshold);  // all bits set, or none
    if constexpr (Same) inlier = inlier & lanes_after<kWide>(static_cast<std::int32_t>(k));
    sum = sum + masked(root(squared), inlier);
    count = count - inlier;
  }
  sums.count = sums.count + count;
  float each[kWide];
  store<kWide, Floats>(each, sum);
  for (std::size_t l = 0; l < kWide; ++l) sums.residuals[l] += static_cast<double>(each[l]);
}

Consensus consensus(const PointsView& p, const PointsView& q, const float* R,
                    float squared_threshold, float* room) {
  const Ends ends = make_ends(p, q, R, room);
  Sums sums = {};
  for (std::size_t i = 0; i < ends.blocks; ++i) {
    add_pairs<true>(ends, i, i, squared_threshold, sums);
    for (std::size_t j = i + 1; j < ends.blocks; ++j)
      if (squared_gap(ends, i, j) < squared_threshold)
        add_pairs<false>(ends, i, j, squared_threshold, sums);
  }
  Consensus out = {0, 0};
  std::int32_t counts[kWide];
  store<kWide, Ints>(counts, sums.count);
  for (std::size_t l = 0; l < kWide; ++l) {
    out.inliers += static_cast<double>(counts[l]);
    out.residuals += sums.residuals[l];
  }
  return out;
}

}  // namespace
}  // namespace emtr::EMTR_KERNEL
