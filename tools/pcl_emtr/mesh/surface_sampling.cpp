#include "mesh/surface_sampling.h"

#include <Eigen/Geometry>
#include <cmath>

namespace cli {
namespace {

// One and two steps of the sequence: the inverses of the plastic number and of its square.
constexpr double kFirst = 0.7548776662466927, kSecond = 0.5698402909980532;

double fraction(double value) { return value - std::floor(value); }

}  // namespace

SurfaceSampling::SurfaceSampling(const std::vector<Eigen::Vector3d>& vertices, const Faces& faces)
    : vertices_(vertices) {
  for (std::size_t face = 0; face < faces.size(); ++face)
    for (std::size_t i = faces.begin_of(face) + 2; i < faces.ends[face]; ++i) {
      const auto& corners = faces.corners;
      const auto a = corners[faces.begin_of(face)], b = corners[i - 1], c = corners[i];
      const Eigen::Vector3d across = vertices[b] - vertices[a], along = vertices[c] - vertices[a];
      const double area = across.cross(along).norm() / 2;
      if (!std::isfinite(area) || !(area > 0)) continue;
      area_ += area;
      triangles_.push_back({a, b, c, area_});
    }
}

std::vector<Eigen::Vector3d> SurfaceSampling::points(std::size_t count) const {
  std::vector<Eigen::Vector3d> out;
  out.reserve(count);
  const auto last = triangles_.end() - 1;
  auto triangle = triangles_.begin();
  for (std::size_t i = 0; i < count; ++i) {
    const double at = (static_cast<double>(i) + 0.5) / static_cast<double>(count) * area_;
    while (triangle != last && triangle->end < at) ++triangle;
    // A triangle is wider towards its far side.
    const double along = std::sqrt(fraction(kFirst * static_cast<double>(i + 1)));
    const double across = fraction(kSecond * static_cast<double>(i + 1));
    const Eigen::Vector3d& a = vertices_[triangle->a];
    const Eigen::Vector3d first = vertices_[triangle->b] - a, second = vertices_[triangle->c] - a;
    out.emplace_back(a + along * ((1 - across) * first + across * second));
  }
  return out;
}

}  // namespace cli
