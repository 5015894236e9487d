#include "refinement/voxel_moments.h"

#include "geometry/range.h"
#include "util/cancellation.h"
#include "voxels/voxel_order.h"

namespace emtr {
namespace {

Moments moments_of(double x, double y, double z) {
  return {1, x, y, z, x * x, x * y, x * z, y * y, y * z, z * z};
}

}  // namespace

VoxelLattice::VoxelLattice(const Cloud& cloud, double leaf, int margin)
    : inverse(1 / static_cast<float>(leaf)) {
  const std::vector<float>* axes[3] = {&cloud.x, &cloud.y, &cloud.z};
  for (int a = 0; a < 3; ++a) {
    const Range range = range_of(*axes[a]);
    low[a] = cell(range.low) - margin;
    size[a] = cell(range.high) - low[a] + margin + 1;
  }
}

VoxelMoments::VoxelMoments(const Cloud& cloud, const VoxelLattice& lattice) {
  std::vector<VoxelRow> items(cloud.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    check_cancelled_each(i, 14);
    items[i] = {lattice.key(cloud, i), static_cast<std::uint32_t>(i)};
  }
  sort_by_voxel(items,
                static_cast<std::uint64_t>(lattice.size[0] * lattice.size[1] * lattice.size[2]));
  Moments sum{};
  for (const VoxelRow& item : items) {
    check_cancelled_each(static_cast<std::size_t>(&item - items.data()), 14);
    if (keys.empty() || item.voxel != keys.back()) {
      keys.push_back(item.voxel);
      before.push_back(sum);
    }
    add(sum, moments_of(cloud.x[item.row], cloud.y[item.row], cloud.z[item.row]));
  }
  before.push_back(sum);
}

std::array<float, 3> VoxelMoments::centroid(std::size_t i) const {
  Moments own = before[i + 1];
  subtract(own, before[i]);
  return {static_cast<float>(own[1] / own[0]), static_cast<float>(own[2] / own[0]),
          static_cast<float>(own[3] / own[0])};
}

std::vector<VoxelRun> ball(const VoxelLattice& lattice, double reach) {
  std::vector<VoxelRun> rows;
  const int maximum = static_cast<int>(reach);
  for (int z = -maximum; z <= maximum; ++z)
    for (int y = -maximum; y <= maximum; ++y) {
      const double remaining = reach * reach - y * y - z * z;
      if (remaining < 0) continue;
      const auto half = static_cast<std::int64_t>(std::sqrt(remaining));
      const std::int64_t center = (z * lattice.size[1] + y) * lattice.size[0];
      rows.push_back({center - half, center + half});
    }
  return rows;
}

}  // namespace emtr
