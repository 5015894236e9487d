#include "colors/color_comparison.h"

#include "colors/correlogram.h"
#include "colors/fall_off.h"
#include "voxels/voxel_grid.h"
#include "voxels/voxel_order.h"

namespace emtr {
namespace {

constexpr double kLeastCoherence = 0.3;  // noise has 0
constexpr double kNeighborReach = 2.1;   // leaves

/// Returns the mean color at each point of the fine surface, that of a cloud; of intensities,
/// without their fall-off.
Cloud fine_colors(const Cloud& points, const PreprocessedCloud& from, const Surface& surface) {
  Cloud out = mean_colors(points, from.colors, static_cast<float>(surface.leaf));
  return from.color_kind == ColorKind::Intensities ? without_fall_off(surface, out) : out;
}

/// Tells whether neighbors are alike, at this leaf or at coarser ones: stripes as narrow as the
/// leaf are not, but their mean differs from what is beside them. Means of noise are noise.
bool is_coherent(const Cloud& points, const Cloud& colors, int k, double leaf) {
  if (coherence(points, channel(colors, k), kNeighborReach * leaf) > kLeastCoherence) return true;
  for (const double scale : {2.0, 4.0}) {
    const auto side = static_cast<float>(scale * leaf);
    if (coherence(voxel_grid(points, side), channel(mean_colors(points, colors, side), k),
                  kNeighborReach * scale * leaf) > kLeastCoherence)
      return true;
  }
  return false;
}

}  // namespace

bool have_comparable_colors(const NormalizedPair& pair) {
  const auto kind = [](const PreprocessedCloudPtr& cloud) {
    return cloud ? cloud->color_kind : ColorKind::None;
  };
  const ColorKind source = kind(pair.preprocessed_source), target = kind(pair.preprocessed_target);
  return source != ColorKind::None && source == target && !pair.extruded;
}

std::unique_ptr<ColorComparison> compare_colors(const NormalizedPair& pair,
                                                const FineSurfaces& fine, const Kernels& kernels) {
  if (!have_comparable_colors(pair)) return nullptr;
  Channels channels =
      make_channels(fine_colors(pair.source, *pair.preprocessed_source, *fine.source),
                    fine_colors(pair.target, *pair.preprocessed_target, *fine.target));
  for (int k = 0; k < kChannels; ++k)
    channels.used[k] = channels.used[k] &&
                       is_coherent(fine.source->points, channels.source, k, fine.leaf()) &&
                       is_coherent(fine.target->points, channels.target, k, fine.leaf());
  if (!channels.any()) return nullptr;
  return std::make_unique<ColorComparison>(fine, channels, kernels);
}

}  // namespace emtr
