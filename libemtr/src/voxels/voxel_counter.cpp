#include "voxels/voxel_counter.h"

#include <algorithm>

#include "voxels/voxel_index.h"

namespace emtr {
namespace {

std::size_t count_bits(std::uint64_t word) {
  return static_cast<std::size_t>(__builtin_popcountll(word));
}

}  // namespace

VoxelCounter::VoxelCounter(const Cloud& cloud)
    : cloud_(cloud), x_(range_of(cloud.x)), y_(range_of(cloud.y)), z_(range_of(cloud.z)) {}

std::size_t VoxelCounter::operator()(float leaf) {
  const float inverse = 1.0f / leaf;
  const int low_x = voxel_index(x_.low, inverse),
            size_x = voxel_index(x_.high, inverse) - low_x + 1;
  const int low_y = voxel_index(y_.low, inverse),
            size_y = voxel_index(y_.high, inverse) - low_y + 1;
  const int low_z = voxel_index(z_.low, inverse),
            size_z = voxel_index(z_.high, inverse) - low_z + 1;
  const auto voxels = static_cast<std::size_t>(size_x) * static_cast<std::size_t>(size_y) *
                      static_cast<std::size_t>(size_z);
  occupied_.assign(voxels / 64 + 1, 0);

  // Takes two steps, so that the first has no branches and no jumps in memory.
  constexpr std::size_t batch = 1024;
  std::uint32_t keys[batch];
  for (std::size_t first = 0; first < cloud_.size(); first += batch) {
    const std::size_t n = std::min(batch, cloud_.size() - first);
    const float *x = &cloud_.x[first], *y = &cloud_.y[first], *z = &cloud_.z[first];
    for (std::size_t i = 0; i < n; ++i) {
      const int column =
          (voxel_index(z[i], inverse) - low_z) * size_y + (voxel_index(y[i], inverse) - low_y);
      keys[i] = static_cast<std::uint32_t>(column * size_x + (voxel_index(x[i], inverse) - low_x));
    }
    for (std::size_t i = 0; i < n; ++i) occupied_[keys[i] / 64] |= std::uint64_t{1} << keys[i] % 64;
  }
  std::size_t count = 0;
  for (const std::uint64_t word : occupied_) count += count_bits(word);
  return count;
}

}  // namespace emtr
