#pragma once

#include <vector>

#include "candidates/dominant_planes.h"
#include "geometry/rigid.h"
#include "geometry/surface.h"

namespace emtr {

/// A point whose surface stands upright on a plane: of a wall, a trunk, a pole.
struct UprightPoint {
  double x, y;     ///< along the plane, radii
  double height;   ///< above it, radii
  double azimuth;  ///< direction that the surface faces, whatever the sign: [0, pi) radians
};

struct Upright {
  Rigid to_plane;  ///< from the normalized frame; then z is the height above the plane
  std::vector<UprightPoint> points;
};

/// Returns some of the surface's points that stand upright on the plane.
Upright upright_points(const Surface& surface, const DominantPlane& plane);

}  // namespace emtr
