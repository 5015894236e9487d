#include "refinement/fine_surfaces.h"

#include <algorithm>
#include <cmath>

#include "refinement/local_refinement.h"

namespace emtr {
namespace {

constexpr double kLeastPoints = 3;  // a cube, on average; finer ones have no normals worth the name
constexpr int kMostAttempts = 4;
constexpr double kQueries = 5e4;  // look-ups of one polish, about

}  // namespace

FineSurfaces fine_surfaces(const NormalizedPair& pair, double leaf, const Kernels& kernels) {
  FineSurfaces out;
  for (int attempt = 0;; ++attempt) {
    const auto downsample = [&](const Cloud& cloud, const PreprocessedCloudPtr& from) {
      const bool given = from && from->normals.size();  // a pair may be made of bare points
      return given ? downsample_surface(cloud, from->normals, leaf) : downsample_surface(cloud, leaf);
    };
    out.source = downsample(pair.source, pair.preprocessed_source);
    out.target = downsample(pair.target, pair.preprocessed_target);
    const auto filling = [](const Cloud& points, const Surface& surface) {
      return static_cast<double>(points.size()) / static_cast<double>(surface.points.size());
    };
    const double least =
        std::min(filling(pair.source, out.source), filling(pair.target, out.target));
    if (least >= kLeastPoints || attempt == kMostAttempts) break;
    leaf *= std::sqrt(1.1 * kLeastPoints / least);
  }
  const LocalRefinementSettings local_refinement;
  const auto reach = static_cast<float>(std::max(local_refinement.first_scale, local_refinement.reach) * leaf);
  const auto near = [&](const Surface& surface) {
    return make_neighbors(surface.points, reach, static_cast<float>(1.5 * leaf), kQueries, kernels);
  };
  out.near_source = near(out.source);
  out.near_target = near(out.target);
  return out;
}

}  // namespace emtr
