#include "refinement/fine_surfaces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "refinement/downsampled_surface.h"
#include "refinement/local_refinement_settings.h"
#include "refinement/voxel_moments.h"
#include "util/thread_team.h"
#include "voxels/voxel_counter.h"

namespace emtr {
namespace {

constexpr double kMinimumPoints =
    3;  // a cube, on average; finer ones have no normals worth the name
constexpr int kMaximumAttempts = 4;
constexpr double kQueries = 5e4;  // nearest-neighbor queries of one refinement, about

constexpr std::int64_t kMostBits = 1 << 26;  // of a voxel each, for a count by bits: 8 MB

// In the memory of a cloud.
struct FineSurface {
  SharedSurface surface;
};
struct OccupiedVoxels {
  std::size_t count;
};

OccupiedVoxels occupied_voxels(const Cloud& cloud, double leaf) {
  const VoxelLattice lattice(cloud, leaf, 0);
  if (lattice.size[0] * lattice.size[1] * lattice.size[2] <= kMostBits)
    return {VoxelCounter(cloud)(static_cast<float>(leaf))};
  return {VoxelMoments(cloud, lattice).keys.size()};
}

}  // namespace

FineSurfaces fine_surfaces(const NormalizedPair& pair, double leaf, double coarsest,
                           const Kernels& kernels, int threads) {
  const Cloud* const clouds[2] = {&pair.source, &pair.target};
  const PreprocessedCloud* const from[2] = {pair.preprocessed_source.get(),
                                            pair.preprocessed_target.get()};
  leaf = pair.leaf_of_radii(leaf);
  const auto for_both = [&](const auto& job) { parallel_for(2, threads, job); };
  for (int attempt = 0; attempt < kMaximumAttempts && leaf != coarsest; ++attempt) {
    double points_per_cube[2];
    for_both([&](std::size_t i) {
      const auto occupied = pair.remembered<OccupiedVoxels>(
          static_cast<int>(i), {leaf}, [&] { return occupied_voxels(*clouds[i], leaf); });
      points_per_cube[i] =
          static_cast<double>(clouds[i]->size()) / static_cast<double>(occupied->count);
    });
    const double filling = std::min(points_per_cube[0], points_per_cube[1]);
    if (filling >= kMinimumPoints) break;
    leaf = std::min(pair.leaf(leaf * std::sqrt(1.1 * kMinimumPoints / filling)), coarsest);
  }
  const LocalRefinementSettings settings;
  const auto reach = static_cast<float>(std::max(settings.first_scale, settings.reach) * leaf);
  std::shared_ptr<const FineSurface> surfaces[2];
  SharedNeighbors near[2];
  for_both([&](std::size_t i) {
    const bool has_normals = from[i] && from[i]->normals.size();  // a pair may be bare points
    surfaces[i] = pair.remembered<FineSurface>(static_cast<int>(i), {leaf}, [&] {
      return FineSurface{has_normals ? downsample_surface(*clouds[i], from[i]->normals, leaf)
                                     : downsample_surface(*clouds[i], leaf, kNormalReach, kernels)};
    });
    const SharedSurface& surface = surfaces[i]->surface;
    near[i] = *surface.memo().get<SharedNeighbors>({reach, kQueries}, [&] {
      return make_neighbors(surface->points, reach, kQueries, kernels);
    });
  });
  return {surfaces[0]->surface, surfaces[1]->surface, near[0], near[1]};
}

}  // namespace emtr
