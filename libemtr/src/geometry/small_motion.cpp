#include "geometry/small_motion.h"

#include "geometry/rotation_vector.h"

namespace emtr {

Rigid moved(const Rigid& pose, const double x[6]) {
  using Rotation = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  const Eigen::Quaterniond turn = exponential(Eigen::Vector3d::Map(x));
  Rigid out;
  // Through a quaternion of length 1: nine numbers would drift away from a rotation.
  Eigen::Map<Rotation>(out.R) = (turn * quaternion(pose.R)).normalized().toRotationMatrix();
  Eigen::Vector3d::Map(out.t) =
      turn * Eigen::Vector3d::Map(pose.t) + Eigen::Vector3d(x[3], x[4], x[5]);
  return out;
}

}  // namespace emtr
