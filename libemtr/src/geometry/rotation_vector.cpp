#include "geometry/rotation_vector.h"

#include "util/constants.h"

namespace emtr {

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
