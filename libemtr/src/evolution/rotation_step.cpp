#include "evolution/rotation_step.h"

#include "geometry/euler.h"
#include "geometry/rotation_vector.h"

namespace emtr {
namespace {

Eigen::Quaterniond quaternion_of(const double angles[3]) {
  return Eigen::Quaterniond(euler_to_rotation(angles));
}

}  // namespace

void rotation_between(const double from[3], const double to[3], double vector[3]) {
  Eigen::Vector3d::Map(vector) = logarithm(quaternion_of(to) * quaternion_of(from).conjugate());
}

void rotate_angles(double angles[3], const double vector[3]) {
  const Eigen::Quaterniond rotated =
      exponential(Eigen::Vector3d::Map(vector)) * quaternion_of(angles);
  rotation_to_euler(rotated.normalized().toRotationMatrix(), angles);
}

}  // namespace emtr
