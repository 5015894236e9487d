#include "geometry/rotation_vector.h"

namespace emtr {

Eigen::Quaterniond exponential(const Eigen::Vector3d& vector) {
  const double angle = vector.norm();
  return angle > 0 ? Eigen::Quaterniond(Eigen::AngleAxisd(angle, vector / angle))
                   : Eigen::Quaterniond::Identity();
}

Eigen::Vector3d logarithm(const Eigen::Quaterniond& rotation) {
  constexpr double pi = 3.14159265358979323846;
  const Eigen::AngleAxisd turn(rotation);
  return (turn.angle() > pi ? turn.angle() - 2 * pi : turn.angle()) * turn.axis();
}

}  // namespace emtr
