#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/cloud.h"
#include "voxels/voxel_index.h"

namespace emtr {

/// Count, sum of the coordinates, and sum of their products xx, xy, xz, yy, yz, zz.
using Moments = std::array<double, 10>;

inline void add(Moments& sum, const Moments& m) {
  for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += m[k];
}

inline void subtract(Moments& sum, const Moments& m) {
  for (std::size_t k = 0; k < sum.size(); ++k) sum[k] -= m[k];
}

/// Where the voxels lie: key = (z * size_y + y) * size_x + x, with a margin of empty ones, so that
/// no row of neighbors runs over into the next.
struct VoxelLattice {
  float inverse;
  std::int64_t low[3], size[3];

  VoxelLattice(const Cloud& cloud, double leaf, int margin);

  std::int64_t cell(float v) const { return voxel_index(v, inverse); }

  std::uint64_t key(const Cloud& cloud, std::size_t i) const {
    return static_cast<std::uint64_t>(
        ((cell(cloud.z[i]) - low[2]) * size[1] + cell(cloud.y[i]) - low[1]) * size[0] +
        cell(cloud.x[i]) - low[0]);
  }
};

/// The occupied voxels in order, and the running sums of the moments before each of them.
struct VoxelMoments {
  std::vector<std::uint64_t> keys;
  std::vector<Moments> before;  // one more than keys

  VoxelMoments(const Cloud& cloud, const VoxelLattice& lattice);

  std::array<float, 3> centroid(std::size_t i) const;
};

/// A row of voxels beside the current one: keys from +first to +last, found by two cursors that
/// only move forward as the current one does.
struct VoxelRun {
  std::int64_t first, last;
  std::size_t begin = 0, end = 0;

  void follow(const std::vector<std::uint64_t>& keys, std::uint64_t key) {
    const auto at = static_cast<std::int64_t>(key);
    while (begin < keys.size() && static_cast<std::int64_t>(keys[begin]) < at + first) ++begin;
    end = std::max(begin, end);
    while (end < keys.size() && static_cast<std::int64_t>(keys[end]) <= at + last) ++end;
  }
};

/// Returns the voxels whose center is within `reach` leaves of the center of the current one.
std::vector<VoxelRun> ball(const VoxelLattice& lattice, double reach);

}  // namespace emtr
