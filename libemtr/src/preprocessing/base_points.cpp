#include "preprocessing/base_points.h"

#include "preprocessing/slab_voxel_grid.h"
#include "util/thread_team.h"
#include "voxels/voxel_grid.h"
#include "voxels/voxel_order.h"

namespace emtr {
namespace {

constexpr std::size_t kMaximumCount = 1u << 20;  // for more points the leaf doubles

}  // namespace

BasePoints read_all_points(const CloudReader& reader, const PointData& data, const Extent& extent,
                           int threads) {
  std::vector<std::size_t> first(reader.blocks());
  std::size_t count = 0;
  for (std::size_t block = 0; block < first.size(); ++block) {
    first[block] = count;
    count += extent.finite[block];
  }
  BasePoints out;
  out.points.resize(count);
  if (data.normals) out.normals.resize(count);
  if (data.colors) out.colors.resize(count);
  parallel_for(first.size(), threads, [&](std::size_t block) {
    std::size_t row = first[block];
    reader.each_finite(block, [&](std::size_t i, const double* p) {
      float q[3];
      extent.to_unit_ball(p, q);
      out.points.set(row, q);
      if (data.normals) {
        data.normals->read_direction(block * CloudReader::kBlock + i, q);
        out.normals.set(row, q);
      }
      if (data.colors) {
        data.colors->read(block * CloudReader::kBlock + i, q);
        out.colors.set(row, q);
      }
      ++row;
    });
  });
  return out;
}

BasePoints read_base_points(const CloudReader& reader, const PointData& data, const Extent& extent,
                            int threads) {
  if (extent.count <= kDownsampledAbove) return read_all_points(reader, data, extent, threads);
  float leaf = kBaseLeaf;
  BasePoints out = voxel_grid_by_slabs(reader, data, extent, leaf, threads);
  while (out.points.size() > kMaximumCount) {
    leaf *= 2;
    if (data.normals) out.normals = mean_normals(out.points, out.normals, leaf);
    if (data.colors) out.colors = mean_colors(out.points, out.colors, leaf);
    out.points = voxel_grid(out.points, leaf);
  }
  return out;
}

}  // namespace emtr
