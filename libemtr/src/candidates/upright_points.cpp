#include "candidates/upright_points.h"

#include <Eigen/Geometry>
#include <cmath>

#include "geometry/spread_rows.h"
#include "util/constants.h"

namespace emtr {
namespace {

using Eigen::Vector3d;

constexpr double kUpright = 0.5;    // cosine of plane and surface at most
constexpr std::size_t kMost = 700;  // of these points

Rigid to_plane(const DominantPlane& plane) {
  int thin = 0;
  plane.normal.cwiseAbs().minCoeff(&thin);
  const Vector3d x = plane.normal.cross(Vector3d::Unit(thin)).normalized();
  const Vector3d y = plane.normal.cross(x);
  Rigid out;
  out.R << x.x(), x.y(), x.z(), y.x(), y.y(), y.z(), plane.normal.x(), plane.normal.y(),
      plane.normal.z();
  out.t = {0, 0, -plane.offset};
  return out;
}

}  // namespace

Upright upright_points(const Surface& surface, const DominantPlane& plane) {
  Upright out{to_plane(plane), {}};
  const Cloud &points = surface.points, &normals = surface.normals;
  std::vector<std::size_t> upright;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3d normal(normals.x[i], normals.y[i], normals.z[i]);
    if (std::abs(normal.dot(plane.normal)) < kUpright) upright.push_back(i);  // not where none is
  }
  for (const std::size_t k : spread_rows(upright.size(), kMost)) {
    const std::size_t i = upright[k];
    const Vector3d p = out.to_plane * Vector3d(points.x[i], points.y[i], points.z[i]);
    const Vector3d n = out.to_plane.rotate(Vector3d(normals.x[i], normals.y[i], normals.z[i]));
    const double azimuth = std::atan2(n.y(), n.x());
    out.points.push_back({p.x(), p.y(), p.z(), azimuth < 0 ? azimuth + kPi : azimuth});
  }
  return out;
}

}  // namespace emtr
