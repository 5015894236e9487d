#include "slabs.h"

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "../features/voxel_grid.h"
#include "../team.h"

namespace emtr {
namespace {

constexpr std::size_t kSlabPoints = 1u << 16;  // a slab and its filter stay in the caches

/// The finite points of one block by layer: their places, and where each layer begins among them.
struct Block {
  std::vector<std::uint16_t> places;
  std::vector<std::uint32_t> begin;
};

/// Which layer of voxels a coordinate in the unit ball lies in.
class Layers {
 public:
  explicit Layers(float leaf) : inverse_(1.0f / leaf), half_(std::ceil(inverse_) + 1) {}
  std::size_t size() const { return static_cast<std::size_t>(2 * half_ + 1); }
  std::size_t of(float v) const {  // as PCL bins
    return static_cast<std::size_t>(std::floor(v * inverse_) + half_);
  }

 private:
  float inverse_, half_;
};

Block sorted(const CloudReader& reader, std::size_t number, const Extent& extent,
             const Layers& layers) {
  Block block;
  block.places.resize(extent.finite[number]);
  block.begin.assign(layers.size() + 1, 0);
  std::vector<std::uint16_t> layer, place;
  layer.reserve(block.places.size());
  place.reserve(block.places.size());
  reader.each_finite(number, [&](std::size_t i, const double* p) {
    float q[3];
    extent.to_unit_ball(p, q);
    const std::size_t at = layers.of(q[extent.longest]);
    layer.push_back(static_cast<std::uint16_t>(at));
    place.push_back(static_cast<std::uint16_t>(i));
    ++block.begin[at + 1];
  });
  for (std::size_t i = 0; i < layers.size(); ++i) block.begin[i + 1] += block.begin[i];
  std::vector<std::uint32_t> next(block.begin.begin(), block.begin.end() - 1);
  for (std::size_t i = 0; i < layer.size(); ++i) block.places[next[layer[i]]++] = place[i];
  return block;
}

/// Layers first to last of each slab, about as many points in each.
std::vector<std::size_t> cut(const std::vector<Block>& blocks, std::size_t layers) {
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

Cloud gather(const CloudReader& reader, const Extent& extent, const std::vector<Block>& blocks,
             std::size_t first, std::size_t last) {
  std::size_t count = 0;
  for (const Block& block : blocks) count += block.begin[last] - block.begin[first];
  Cloud out;
  out.resize(count);
  std::size_t row = 0;
  for (std::size_t b = 0; b < blocks.size(); ++b)
    for (std::uint32_t i = blocks[b].begin[first]; i < blocks[b].begin[last]; ++i, ++row) {
      double p[3];
      float q[3];
      reader.read(b * CloudReader::kBlock + blocks[b].places[i], p);
      extent.to_unit_ball(p, q);
      out.x[row] = q[0];
      out.y[row] = q[1];
      out.z[row] = q[2];
    }
  return out;
}

void append(std::vector<float>& to, const std::vector<float>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

}  // namespace

Cloud thin_by_slabs(const CloudReader& reader, const Extent& extent, float leaf, int threads) {
  const Layers layers(leaf);
  std::vector<Block> blocks(reader.blocks());
  in_parallel(blocks.size(), threads,
              [&](std::size_t i) { blocks[i] = sorted(reader, i, extent, layers); });

  const std::vector<std::size_t> cuts = cut(blocks, layers.size());
  std::vector<Cloud> slabs(cuts.size() - 1);
  in_parallel(slabs.size(), threads, [&](std::size_t i) {
    const Cloud slab = gather(reader, extent, blocks, cuts[i], cuts[i + 1]);
    if (slab.size()) slabs[i] = voxel_grid(slab, leaf);
  });

  Cloud out;
  for (const Cloud& slab : slabs) {
    append(out.x, slab.x);
    append(out.y, slab.y);
    append(out.z, slab.z);
  }
  return out;
}

}  // namespace emtr
