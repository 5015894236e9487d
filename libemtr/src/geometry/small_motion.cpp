#include "geometry/small_motion.h"

#include "geometry/rotation_vector.h"

namespace emtr {

Rigid moved(const Rigid& pose, const double x[6]) {
  const Eigen::Quaterniond rotation = exponential(Eigen::Vector3d::Map(x));
  Rigid out;
  // A quaternion of length 1 stays a rotation; nine numbers would drift away from one.
  out.R = (rotation * Eigen::Quaterniond(pose.R)).normalized().toRotationMatrix();
  out.t = rotation * pose.t + Eigen::Vector3d(x[3], x[4], x[5]);
  return out;
}

}  // namespace emtr
