#pragma once

#include <Eigen/Geometry>

namespace emtr {

/// A rotation vector is axis times angle, in radians.
Eigen::Quaterniond exponential(const Eigen::Vector3d& vector);

/// The shortest one: at most pi long.
Eigen::Vector3d logarithm(const Eigen::Quaterniond& rotation);

}  // namespace emtr
