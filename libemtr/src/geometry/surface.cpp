#include "geometry/surface.h"

#include <algorithm>
#include <utility>

namespace emtr {
namespace {

std::vector<SurfacePoint> interleave(const Cloud& p, const Cloud& n) {
  std::vector<SurfacePoint> out(std::min(p.size(), n.size()));
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = {{p.x[i], p.y[i], p.z[i]}, {n.x[i], n.y[i], n.z[i]}};
  return out;
}

Cloud every_nth(const Cloud& cloud, std::size_t step) {
  Cloud out;
  out.resize((cloud.size() + step - 1) / step);
  for (std::size_t i = 0; i < out.size(); ++i) {
    out.x[i] = cloud.x[i * step];
    out.y[i] = cloud.y[i * step];
    out.z[i] = cloud.z[i * step];
  }
  return out;
}

}  // namespace

void orient_normals(const Cloud& p, const std::array<float, 3>& viewpoint, Cloud& n) {
  const auto [x, y, z] = viewpoint;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const float side = (n.x[i] * (x - p.x[i]) + n.y[i] * (y - p.y[i])) + n.z[i] * (z - p.z[i]);
    if (!(side < 0)) continue;
    n.x[i] = -n.x[i];
    n.y[i] = -n.y[i];
    n.z[i] = -n.z[i];
  }
}

Surface every_nth(const Surface& surface, std::size_t step) {
  return {every_nth(surface.points, step), every_nth(surface.normals, step), surface.leaf};
}

SharedSurface::SharedSurface(Surface surface) {
  std::vector<SurfacePoint> interleaved = interleave(surface.points, surface.normals);
  owned_ = std::make_shared<const Owned>(Owned{std::move(surface), std::move(interleaved), {}});
}

}  // namespace emtr
