#include "preprocessing/slab_voxel_grid.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "util/thread_team.h"
#include "voxels/voxel_grid.h"
#include "voxels/voxel_index.h"
#include "voxels/voxel_order.h"

namespace emtr {
namespace {

constexpr std::size_t kSlabPoints = 1u << 16;  // a slab and its filter stay in the caches
constexpr std::uint32_t kAhead = 16;           // points: those of a layer are all over a block

/// The places of one block's finite points, ordered by layer, and where each layer begins.
struct Block {
  std::vector<std::uint16_t> places;
  std::vector<std::uint32_t> begin;
};

/// Tells in which layer of voxels a coordinate in the unit ball lies.
class Layers {
 public:
  explicit Layers(float leaf)
      : inverse_(1.0f / leaf), half_(static_cast<int>(std::ceil(inverse_)) + 1) {}
  std::size_t size() const {
    const int layers = 2 * half_ + 1;
    return static_cast<std::size_t>(layers);
  }
  std::size_t of(float v) const {
    const int layer = voxel_index(v, inverse_) + half_;
    return static_cast<std::size_t>(layer);
  }

 private:
  float inverse_;
  int half_;
};

Block sort_by_layer(const CloudReader& reader, std::size_t number, const Extent& extent,
                    const Layers& layers) {
  Block block;
  block.places.resize(extent.finite[number]);
  block.begin.assign(layers.size() + 1, 0);
  std::vector<std::uint16_t> layer(block.places.size()), place(block.places.size());
  std::size_t k = 0;
  reader.each_finite(number, [&](std::size_t i, const double* p) {
    float q[3];
    extent.to_unit_ball(p, q);
    const std::size_t at = layers.of(q[extent.longest]);
    layer[k] = static_cast<std::uint16_t>(at);
    place[k] = static_cast<std::uint16_t>(i);
    ++k;
    ++block.begin[at + 1];
  });
  for (std::size_t i = 0; i < layers.size(); ++i) block.begin[i + 1] += block.begin[i];
  std::vector<std::uint32_t> next(block.begin.begin(), block.begin.end() - 1);
  for (std::size_t i = 0; i < layer.size(); ++i) block.places[next[layer[i]]++] = place[i];
  return block;
}

/// Cuts the layers into slabs of about kSlabPoints points; returns where each slab begins and the
/// end of the last.
std::vector<std::size_t> cut_slabs(const std::vector<Block>& blocks, std::size_t layers) {
  std::vector<std::size_t> cuts = {0};
  std::size_t points = 0;
  for (std::size_t layer = 0; layer < layers; ++layer) {
    for (const Block& block : blocks) points += block.begin[layer + 1] - block.begin[layer];
    if (points < kSlabPoints && layer + 1 < layers) continue;
    cuts.push_back(layer + 1);
    points = 0;
  }
  return cuts;
}

BasePoints gather(const CloudReader& reader, const PointData& data, const Extent& extent,
                  const std::vector<Block>& blocks, std::size_t first, std::size_t last) {
  std::size_t count = 0;
  for (const Block& block : blocks) count += block.begin[last] - block.begin[first];
  BasePoints out;
  out.points.resize(count);
  if (data.normals) out.normals.resize(count);
  if (data.colors) out.colors.resize(count);
  std::size_t row = 0;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const std::uint32_t end = blocks[b].begin[last];
    for (std::uint32_t i = blocks[b].begin[first]; i < end; ++i, ++row) {
      double p[3];
      float q[3];
      const auto at = [&](std::uint32_t k) {
        return b * CloudReader::kBlock + blocks[b].places[k];
      };
      reader.prefetch(at(std::min(i + kAhead, end - 1)));
      reader.read(at(i), p);
      extent.to_unit_ball(p, q);
      out.points.set(row, q);
      if (data.normals) {
        data.normals->read_direction(at(i), q);
        out.normals.set(row, q);
      }
      if (!data.colors) continue;
      data.colors->read(at(i), q);
      out.colors.set(row, q);
    }
  }
  return out;
}

}  // namespace

BasePoints voxel_grid_by_slabs(const CloudReader& reader, const PointData& data,
                               const Extent& extent, float leaf, int threads) {
  const Layers layers(leaf);
  std::vector<Block> blocks(reader.blocks());
  parallel_for(blocks.size(), threads,
               [&](std::size_t i) { blocks[i] = sort_by_layer(reader, i, extent, layers); });

  const std::vector<std::size_t> cuts = cut_slabs(blocks, layers.size());
  std::vector<BasePoints> slabs(cuts.size() - 1);
  parallel_for(slabs.size(), threads, [&](std::size_t i) {
    const BasePoints slab = gather(reader, data, extent, blocks, cuts[i], cuts[i + 1]);
    if (slab.points.size() == 0) return;
    slabs[i].points = voxel_grid(slab.points, leaf);
    if (data.normals) slabs[i].normals = mean_normals(slab.points, slab.normals, leaf);
    if (data.colors) slabs[i].colors = mean_colors(slab.points, slab.colors, leaf);
  });

  BasePoints out;
  for (const BasePoints& slab : slabs) {
    out.points.append(slab.points);
    out.normals.append(slab.normals);
    out.colors.append(slab.colors);
  }
  return out;
}

}  // namespace emtr
