#include "verdict/overlap.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "geometry/transform.h"
#include "util/thread_team.h"

namespace emtr {
namespace {

constexpr std::size_t kMaximumPoints = 5000;  // for a share to half a per cent
// Distance to the plane over distance to the point where surfaces cross within a leaf: measured on
// scans that do not belong together (median 0.7, some 0.8). Noise alone comes near it: the minimum
// keeps the scale from shrinking to nothing there.
constexpr double kRandomFlatness = 0.75, kMinimumScale = 0.1;

Cloud some(const Cloud& cloud) {
  std::vector<std::size_t> rows(std::min(cloud.size(), kMaximumPoints));
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = i * cloud.size() / rows.size();
  return cloud.select(rows);
}

/// How the points of one cloud lie on the surface of the other.
struct OneWay {
  double overlap = 0;
  double rmse = std::numeric_limits<double>::quiet_NaN(), plane_rmse = rmse;

  double flatness() const { return plane_rmse / rmse; }
};

OneWay evaluate_one_way(const Cloud& cloud, const Rigid& pose, const SharedSurface& surface,
                        const Neighbors& near, const Kernels& kernels) {
  const Cloud points = some(cloud);
  const std::size_t n = points.size();
  Cloud moved;
  moved.resize(n);
  transform(kernels, points, pose, moved.x.data(), moved.y.data(), moved.z.data());
  std::vector<std::int32_t> index(n);
  std::vector<float> squared(n);
  near.nearest(moved.view(), index.data(), squared.data());

  double correspondences = 0, squares = 0, planes = 0, plane_squares = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const auto d = static_cast<double>(squared[i]);
    if (index[i] < 0 || d > surface->leaf * surface->leaf) continue;
    ++correspondences;
    squares += d;
    const SurfacePoint& q = surface.interleaved()[static_cast<std::size_t>(index[i])];
    const float e = (q.n[0] * (moved.x[i] - q.p[0]) + q.n[1] * (moved.y[i] - q.p[1])) +
                    q.n[2] * (moved.z[i] - q.p[2]);
    if (std::isnan(e)) continue;  // no normal
    ++planes;
    plane_squares += static_cast<double>(e) * static_cast<double>(e);
  }
  OneWay out;
  out.overlap = correspondences / static_cast<double>(n);
  if (correspondences > 0) out.rmse = std::sqrt(squares / correspondences);
  if (planes > 0) out.plane_rmse = std::sqrt(plane_squares / planes);
  return out;
}

}  // namespace

Overlap evaluate_overlap(const NormalizedPair& pair, const FineSurfaces& fine, const Rigid& pose,
                         const Kernels& kernels, int threads) {
  OneWay source, target;
  parallel_for(2, threads, [&](std::size_t i) {
    if (i == 0)
      source = evaluate_one_way(pair.source, pose, fine.target, *fine.near_target, kernels);
    else
      target =
          evaluate_one_way(pair.target, pose.inverse(), fine.source, *fine.near_source, kernels);
  });
  const double flatness = (source.flatness() + target.flatness()) / 2;
  return {source.overlap, target.overlap, source.rmse, source.plane_rmse, flatness};
}

double surface_mismatch(const Overlap& overlap, const NormalizedPair& pair,
                        const FineSurfaces& fine, const Kernels& kernels, int threads) {
  OneWay source, target;
  parallel_for(2, threads, [&](std::size_t i) {
    if (i == 0)
      source = evaluate_one_way(pair.source, {}, fine.source, *fine.near_source, kernels);
    else
      target = evaluate_one_way(pair.target, {}, fine.target, *fine.near_target, kernels);
  });
  const double own = std::max(source.flatness(), target.flatness());
  return (overlap.flatness - own) / std::max(kRandomFlatness - own, kMinimumScale);
}

}  // namespace emtr
