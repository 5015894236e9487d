#include "refinement/downsampled_surface.h"

#include <algorithm>
#include <array>
#include <vector>

#include "refinement/voxel_moments.h"
#include "util/cancellation.h"
#include "voxels/voxel_order.h"

namespace emtr {
namespace {

constexpr std::size_t kBlock = 256;  // voxels whose normals are computed side by side

/// Moments of some neighborhoods as Kernels::plane_normals() reads them, about their centroids:
/// those of raw coordinates need double precision.
class CenteredMoments {
 public:
  void set(std::size_t i, const Moments& m) {
    const bool enough = m[0] >= kMinimumForNormal;
    const auto put = [&](std::size_t k, double value) {
      values_[k * kBlock + i] = enough ? static_cast<float>(value) : 0.0f;
    };
    put(0, m[0]);
    for (std::size_t k = 1; k < 4; ++k) put(k, 0);
    std::size_t k = 4;
    for (std::size_t a = 1; a < 4; ++a)
      for (std::size_t b = a; b < 4; ++b, ++k) put(k, m[k] - m[a] * m[b] / m[0]);
  }

  /// Writes the normals of the neighborhoods of the points first to first + count.
  void write_normals(const Cloud& points, std::size_t first, std::size_t count,
                     const Kernels& kernels, Cloud& normals) const {
    constexpr float kAnySide[3] = {0, 0, 0};
    PointsView block = points.view();
    block.x += first, block.y += first, block.z += first, block.size = count;
    kernels.plane_normals(values_.data(), kBlock, block, kAnySide, normals.x.data() + first,
                          normals.y.data() + first, normals.z.data() + first);
  }

 private:
  std::array<float, 10 * kBlock> values_{};
};

}  // namespace

Surface downsample_surface(const Cloud& cloud, double leaf, double reach, const Kernels& kernels) {
  Surface out;
  out.leaf = leaf;
  if (cloud.size() == 0) return out;
  const VoxelLattice lattice(cloud, leaf, static_cast<int>(reach));
  const VoxelMoments voxels(cloud, lattice);
  std::vector<VoxelRun> rows = ball(lattice, reach);
  const std::size_t n = voxels.keys.size();
  out.points.resize(n);
  out.normals.resize(n);
  CenteredMoments block;
  for (std::size_t first = 0; first < n; first += kBlock) {
    check_cancelled();
    const std::size_t count = std::min(kBlock, n - first);
    for (std::size_t i = 0; i < count; ++i) {
      out.points.set(first + i, voxels.centroid(first + i).data());
      Moments around{};
      for (VoxelRun& row : rows) {
        row.follow(voxels.keys, voxels.keys[first + i]);
        if (row.begin == row.end) continue;
        add(around, voxels.before[row.end]);
        subtract(around, voxels.before[row.begin]);
      }
      block.set(i, around);
    }
    block.write_normals(out.points, first, count, kernels, out.normals);
  }
  return out;
}

Surface downsample_surface(const Cloud& cloud, const Cloud& normals, double leaf) {
  Surface out;
  out.leaf = leaf;
  if (cloud.size() == 0) return out;
  const VoxelMoments voxels(cloud, VoxelLattice(cloud, leaf, 0));
  out.points.resize(voxels.keys.size());
  for (std::size_t i = 0; i < voxels.keys.size(); ++i) out.points.set(i, voxels.centroid(i).data());
  out.normals = mean_normals(cloud, normals, static_cast<float>(leaf));
  return out;
}

}  // namespace emtr
