#include "geometry/rotation_vector.h"

#include "util/constants.h"

namespace emtr {

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& a) {
  Eigen::Matrix3d out;
  out << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return out;
}

Eigen::Quaterniond exponential(const Eigen::Vector3d& vector) {
  const double angle = vector.norm();
  return angle > 0 ? Eigen::Quaterniond(Eigen::AngleAxisd(angle, vector / angle))
                   : Eigen::Quaterniond::Identity();
}

Eigen::Vector3d logarithm(const Eigen::Quaterniond& rotation) {
  const Eigen::AngleAxisd angle_axis(rotation);
  const double angle = angle_axis.angle();
  return (angle > kPi ? angle - 2 * kPi : angle) * angle_axis.axis();
}

}  // namespace emtr
