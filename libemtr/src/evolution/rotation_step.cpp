#include "evolution/rotation_step.h"

#include "geometry/rotation_vector.h"
#include "geometry/euler.h"

namespace emtr {
namespace {

using Rotation = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

Eigen::Quaterniond quaternion_of(const double angles[3]) {
  double R[9];
  euler_to_rotation(angles, R);
  return quaternion(R);
}

}  // namespace

void rotation_between(const double from[3], const double to[3], double vector[3]) {
  Eigen::Vector3d::Map(vector) = logarithm(quaternion_of(to) * quaternion_of(from).conjugate());
}

void turn(double angles[3], const double vector[3]) {
  const Eigen::Quaterniond turned =
      exponential(Eigen::Vector3d::Map(vector)) * quaternion_of(angles);
  double R[9];
  Eigen::Map<Rotation>{R} = turned.normalized().toRotationMatrix();
  rotation_to_euler(R, angles);
}

}  // namespace emtr
