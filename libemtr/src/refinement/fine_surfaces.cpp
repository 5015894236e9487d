#include "refinement/fine_surfaces.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "refinement/downsampled_surface.h"
#include "refinement/local_refinement_settings.h"
#include "util/thread_team.h"

namespace emtr {
namespace {

constexpr double kMinimumPoints =
    3;  // a cube, on average; finer ones have no normals worth the name
constexpr int kMaximumAttempts = 4;
constexpr double kQueries = 5e4;  // nearest-neighbor queries of one refinement, about

double points_per_cube(const Cloud& cloud, const Surface& surface) {
  return static_cast<double>(cloud.size()) / static_cast<double>(surface.points.size());
}

}  // namespace

FineSurfaces fine_surfaces(const NormalizedPair& pair, double leaf, double coarsest,
                           const Kernels& kernels, int threads) {
  const Cloud* const clouds[2] = {&pair.source, &pair.target};
  const PreprocessedCloud* const from[2] = {pair.preprocessed_source.get(),
                                            pair.preprocessed_target.get()};
  const auto for_both = [&](const auto& job) { parallel_for(2, threads, job); };
  Surface surfaces[2];
  for (int attempt = 0;; ++attempt) {
    for_both([&](std::size_t i) {
      const bool has_normals = from[i] && from[i]->normals.size();  // a pair may be bare points
      surfaces[i] = has_normals ? downsample_surface(*clouds[i], from[i]->normals, leaf)
                                : downsample_surface(*clouds[i], leaf, kNormalReach, kernels);
    });
    const double filling = std::min(points_per_cube(pair.source, surfaces[0]),
                                    points_per_cube(pair.target, surfaces[1]));
    if (filling >= kMinimumPoints || attempt == kMaximumAttempts || leaf == coarsest) break;
    leaf = std::min(leaf * std::sqrt(1.1 * kMinimumPoints / filling), coarsest);
  }
  const LocalRefinementSettings settings;
  const auto reach = static_cast<float>(std::max(settings.first_scale, settings.reach) * leaf);
  std::unique_ptr<Neighbors> near[2];
  for_both([&](std::size_t i) {
    near[i] = make_neighbors(surfaces[i].points, reach, kQueries, kernels);
  });
  return {std::move(surfaces[0]), std::move(surfaces[1]), std::move(near[0]), std::move(near[1])};
}

}  // namespace emtr
