#include "geometry/pose_distance.h"

#include <cmath>

namespace emtr {

bool within(const Rigid& a, const Rigid& b, const PoseDistance& limit) {
  const double offset = std::hypot(a.t[0] - b.t[0], a.t[1] - b.t[1], a.t[2] - b.t[2]);
  return offset <= limit.offset && rotation_distance(a.R, b.R) <= limit.angle;
}

}  // namespace emtr
