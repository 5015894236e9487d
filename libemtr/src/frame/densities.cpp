#include "densities.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "../error.h"
#include "../features/resolution.h"
#include "../features/voxel_grid.h"

namespace emtr {
namespace {

constexpr double kFinestLeaf = 2e-3, kCoarsestLeaf = 1.0;

/// The leaf whose count of points comes nearest to `wanted`, between two bounds. The count falls
/// with the leaf but for jitter, so the best leaf met on the way is kept.
double find_leaf(const std::function<std::size_t(float)>& count, double wanted, double finest) {
  double low = std::log(finest), high = std::log(kCoarsestLeaf);
  double best = finest, best_error = HUGE_VAL;
  for (int step = 0; step < 24; ++step) {
    const double middle = (low + high) / 2;
    const double n = static_cast<double>(count(static_cast<float>(std::exp(middle))));
    const double error = std::abs(n - wanted);
    if (error < best_error) {
      best_error = error;
      best = std::exp(middle);
    }
    if (error <= 0.002 * wanted) break;
    (n > wanted ? low : high) = middle;
  }
  return best;
}

/// Below 1.5 point spacings or so a voxel holds single points, and neither thinning nor the
/// neighbourhoods of normals and features work. Matters only for clouds of few points.
double finest_leaf(const NormalisedPair& pair, const Settings& settings) {
  const auto points = pair.source.size() + pair.target.size();
  if (points > 4 * static_cast<std::size_t>(settings.dense_points)) return kFinestLeaf;
  const double spacing = std::max(mean_resolution(pair.source), mean_resolution(pair.target));
  return std::clamp(settings.minimum_leaf_spacing * spacing, kFinestLeaf, kCoarsestLeaf / 2);
}

/// One leaf serves both clouds, so a cloud much smaller than the other can vanish in a few voxels.
void require_some_left(const Cloud& cloud, const char* name, double leaf, double scale) {
  constexpr std::size_t least = 10;  // a mere dot at the origin already fills 8 voxels
  if (cloud.size() >= least) return;
  throw Error(EMTR_ERROR_CLOUD,
              std::string(name) + " cloud: thinned to " + std::to_string(cloud.size()) +
                  " points at the leaf that serves both clouds (" + std::to_string(leaf * scale) +
                  " in your unit), expected at least " + std::to_string(least) +
                  ": it has too few points, or is too small beside the other");
}

}  // namespace

Densities thin(const NormalisedPair& pair, const Settings& settings) {
  Densities out;
  const auto dense_count = [&](float leaf) {
    return count_voxels(pair.source, leaf) + count_voxels(pair.target, leaf);
  };
  out.leaf_dense = find_leaf(dense_count, settings.dense_points, finest_leaf(pair, settings));
  out.source_dense = voxel_grid(pair.source, static_cast<float>(out.leaf_dense));
  out.target_dense = voxel_grid(pair.target, static_cast<float>(out.leaf_dense));

  require_some_left(out.source_dense, "source", out.leaf_dense, pair.frame.scale);
  require_some_left(out.target_dense, "target", out.leaf_dense, pair.frame.scale);

  // A cloud too coarse for the dense count keeps the ratio of sparse to dense, on which the
  // paper's saving rests.
  const double dense = static_cast<double>(out.source_dense.size() + out.target_dense.size());
  const double sparse = settings.sparse_points * std::min(1.0, dense / settings.dense_points);
  const auto sparse_count = [&](float leaf) { return count_voxels(pair.source, leaf); };
  out.leaf_sparse = find_leaf(sparse_count, sparse, out.leaf_dense);
  out.source_sparse = voxel_grid(pair.source, static_cast<float>(out.leaf_sparse));
  out.target_sparse = voxel_grid(pair.target, static_cast<float>(out.leaf_sparse));
  return out;
}

}  // namespace emtr
