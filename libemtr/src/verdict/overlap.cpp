#include "verdict/overlap.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "geometry/transform.h"

namespace emtr {
namespace {

constexpr std::size_t kMost = 5000;  // for a share to half a per cent
// Distance to the plane over distance to the point where surfaces cross within a leaf: measured on
// scans that do not belong together (median 0.7, some 0.8). Noise alone comes near it: `kRoom`
// keeps the scale from shrinking to nothing there.
constexpr double kAtRandom = 0.75, kRoom = 0.1;

Cloud some(const Cloud& cloud) {
  const std::size_t n = std::min(cloud.size(), kMost);
  Cloud out;
  out.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t row = i * cloud.size() / n;
    out.x[i] = cloud.x[row];
    out.y[i] = cloud.y[row];
    out.z[i] = cloud.z[row];
  }
  return out;
}

/// Of the points of one cloud against the surface of the other.
struct Side {
  double overlap = 0;
  double rmse = std::numeric_limits<double>::quiet_NaN(), plane_rmse = rmse;

  double flatness() const { return plane_rmse / rmse; }
};

Side ask(const Cloud& cloud, const Rigid& pose, const Surface& surface, const Neighbors& near,
         const Kernels& kernels) {
  const Cloud still = some(cloud);
  const std::size_t n = still.size();
  Cloud asked;
  asked.resize(n);
  transform(kernels, still, pose, asked.x.data(), asked.y.data(), asked.z.data());
  std::vector<std::int32_t> index(n);
  std::vector<float> squared(n);
  near.nearest(asked.view(), index.data(), squared.data());

  double partners = 0, squares = 0, planes = 0, plane_squares = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const auto d = static_cast<double>(squared[i]);
    if (index[i] < 0 || d > surface.leaf * surface.leaf) continue;
    ++partners;
    squares += d;
    const auto k = static_cast<std::size_t>(index[i]);
    const Cloud &q = surface.points, &normal = surface.normals;
    const float e = (normal.x[k] * (asked.x[i] - q.x[k]) + normal.y[k] * (asked.y[i] - q.y[k])) +
                    normal.z[k] * (asked.z[i] - q.z[k]);
    if (std::isnan(e)) continue;  // no normal
    ++planes;
    plane_squares += static_cast<double>(e) * static_cast<double>(e);
  }
  Side out;
  out.overlap = partners / static_cast<double>(n);
  if (partners > 0) out.rmse = std::sqrt(squares / partners);
  if (planes > 0) out.plane_rmse = std::sqrt(plane_squares / planes);
  return out;
}

}  // namespace

Overlap evaluate_overlap(const NormalizedPair& pair, const FineSurfaces& fine, const Rigid& pose,
                const Kernels& kernels) {
  const Side source = ask(pair.source, pose, fine.target, *fine.near_target, kernels);
  const Side target = ask(pair.target, pose.inverse(), fine.source, *fine.near_source, kernels);
  const double flatness = (source.flatness() + target.flatness()) / 2;
  return {source.overlap, target.overlap, source.rmse, source.plane_rmse, flatness};
}

double surface_mismatch(const Overlap& agreement, const NormalizedPair& pair, const FineSurfaces& fine,
                const Kernels& kernels) {
  const double own =
      std::max(ask(pair.source, {}, fine.source, *fine.near_source, kernels).flatness(),
               ask(pair.target, {}, fine.target, *fine.near_target, kernels).flatness());
  return (agreement.flatness - own) / std::max(kAtRandom - own, kRoom);
}

}  // namespace emtr
