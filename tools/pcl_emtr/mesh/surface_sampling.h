#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "mesh/faces.h"

namespace cli {

/// Samples surfaces evenly. The faces lie one after the other along a line, each as long as its
/// area, and the points lie at equal distances on that line: each face gets its share to within one
/// point. Within the faces a low-discrepancy sequence (R2, of the plastic number) places them.
/// There is no random number, so that one mesh always gives the same points.
class SurfaceSampling {
 public:
  /// Measures the faces over these vertices. A face of more than three corners is a fan of
  /// triangles about its first one. Triangles with a corner that is not finite have no area.
  SurfaceSampling(const std::vector<Eigen::Vector3d>& vertices, const Faces& faces);

  double area() const { return area_; }

  /// Returns so many points; the area must be positive and finite.
  std::vector<Eigen::Vector3d> points(std::size_t count) const;

 private:
  struct Triangle {
    std::uint32_t a, b, c;
    double end;  // of its part of the line
  };
  const std::vector<Eigen::Vector3d>& vertices_;
  std::vector<Triangle> triangles_;  // those with an area
  double area_ = 0;
};

}  // namespace cli
