#include "refinement/fine_surfaces.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "refinement/downsampled_surface.h"
#include "refinement/local_refinement_settings.h"

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
                           const Kernels& kernels) {
  Surface source, target;
  for (int attempt = 0;; ++attempt) {
    const auto downsample = [&](const Cloud& cloud, const PreprocessedCloudPtr& from) {
      const bool has_normals = from && from->normals.size();  // a pair may be made of bare points
      return has_normals ? downsample_surface(cloud, from->normals, leaf)
                         : downsample_surface(cloud, leaf);
    };
    source = downsample(pair.source, pair.preprocessed_source);
    target = downsample(pair.target, pair.preprocessed_target);
    const double filling =
        std::min(points_per_cube(pair.source, source), points_per_cube(pair.target, target));
    if (filling >= kMinimumPoints || attempt == kMaximumAttempts || leaf == coarsest) break;
    leaf = std::min(leaf * std::sqrt(1.1 * kMinimumPoints / filling), coarsest);
  }
  const LocalRefinementSettings settings;
  const auto reach = static_cast<float>(std::max(settings.first_scale, settings.reach) * leaf);
  const auto near = [&](const Surface& surface) {
    return make_neighbors(surface.points, reach, static_cast<float>(1.5 * leaf), kQueries, kernels);
  };
  auto near_source = near(source), near_target = near(target);
  return {std::move(source), std::move(target), std::move(near_source), std::move(near_target)};
}

}  // namespace emtr
