#pragma once

#include <Eigen/Geometry>

namespace emtr {

/// Returns the matrix of the cross product: cross_matrix(a) b = a x b.
Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& a);

/// Returns the rotation of a rotation vector: axis times angle, in radians.
Eigen::Quaterniond exponential(const Eigen::Vector3d& vector);

/// Returns the shortest rotation vector, at most pi long.
Eigen::Vector3d logarithm(const Eigen::Quaterniond& rotation);

}  // namespace emtr
