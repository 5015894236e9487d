#include "small_motion.h"

#include <Eigen/Geometry>

namespace emtr {

Rigid moved(const Rigid& pose, const double x[6]) {
  using Rotation = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  const Eigen::Vector3d vector(x[0], x[1], x[2]);
  const double angle = vector.norm();
  const Eigen::Quaterniond turn = angle > 0
                                      ? Eigen::Quaterniond(Eigen::AngleAxisd(angle, vector / angle))
                                      : Eigen::Quaterniond::Identity();
  const Eigen::Quaterniond before(Eigen::Matrix3d(Eigen::Map<const Rotation>(pose.R)));
  Rigid out;
  // Through a quaternion of length 1: nine numbers would drift away from a rotation.
  Eigen::Map<Rotation>(out.R) = (turn * before).normalized().toRotationMatrix();
  Eigen::Vector3d::Map(out.t) =
      turn * Eigen::Vector3d::Map(pose.t) + Eigen::Vector3d(x[3], x[4], x[5]);
  return out;
}

}  // namespace emtr
