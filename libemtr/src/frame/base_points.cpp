#include "base_points.h"

#include "../features/voxel_grid.h"
#include "../team.h"
#include "slabs.h"

namespace emtr {
namespace {

constexpr float kLeaf = 0.004f;          // some tenth of the dense leaf
constexpr std::size_t kMost = 1u << 20;  // above it the leaf is doubled

Cloud all_points(const CloudReader& reader, const Extent& extent, int threads) {
  std::vector<std::size_t> first(reader.blocks());
  std::size_t count = 0;
  for (std::size_t block = 0; block < first.size(); ++block) {
    first[block] = count;
    count += extent.finite[block];
  }
  Cloud out;
  out.resize(count);
  in_parallel(first.size(), threads, [&](std::size_t block) {
    std::size_t row = first[block];
    reader.each_finite(block, [&](std::size_t, const double* p) {
      float q[3];
      extent.to_unit_ball(p, q);
      out.x[row] = q[0];
      out.y[row] = q[1];
      out.z[row] = q[2];
      ++row;
    });
  });
  return out;
}

}  // namespace

Cloud base_points(const CloudReader& reader, const Extent& extent, int threads) {
  if (extent.count <= kThinnedAbove) return all_points(reader, extent, threads);
  float leaf = kLeaf;
  Cloud out = thin_by_slabs(reader, extent, leaf, threads);
  while (out.size() > kMost) out = voxel_grid(out, leaf *= 2);
  return out;
}

}  // namespace emtr
