#pragma once

#include <Eigen/Geometry>

namespace emtr {

/// Returns the rotation of a rotation vector: axis times angle, in radians.
Eigen::Quaterniond exponential(const Eigen::Vector3d& vector);

/// Returns the shortest rotation vector, at most pi long.
Eigen::Vector3d logarithm(const Eigen::Quaterniond& rotation);

}  // namespace emtr
