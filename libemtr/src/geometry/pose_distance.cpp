#include "geometry/pose_distance.h"

#include <cmath>

namespace emtr {

bool is_same_pose(const Rigid& a, const Rigid& b, const PoseDistance& limit) {
  const double translation = std::hypot(a.t[0] - b.t[0], a.t[1] - b.t[1], a.t[2] - b.t[2]);
  return translation <= limit.translation && rotation_distance(a.R, b.R) <= limit.angle;
}

}  // namespace emtr
