#pragma once

#include <Eigen/Core>
#include <cstddef>

namespace emtr {

/// A rigid transformation, source into target: q = R p + t.
///
/// Products are summed column by column, in this order on every machine: Eigen's own products
/// reorder or fuse the terms as the instruction set allows, which would change the last bits.
struct Rigid {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d t = Eigen::Vector3d::Zero();

  /// Returns R p, the rotation of a direction.
  Eigen::Vector3d rotate(const Eigen::Vector3d& p) const {
    return R.col(0) * p.x() + R.col(1) * p.y() + R.col(2) * p.z();
  }

  /// Returns R p + t.
  Eigen::Vector3d operator*(const Eigen::Vector3d& p) const {
    return R.col(0) * p.x() + R.col(1) * p.y() + R.col(2) * p.z() + t;
  }

  /// Returns the transformation that applies `first` and then this one.
  Rigid operator*(const Rigid& first) const;

  Rigid inverse() const;
};

/// Writes a pose as a row-major 4x4 matrix.
void to_matrix(const Rigid& pose, double transformation[16]);

/// Reads a pose from a row-major 4x4 matrix, of which the last row is taken to be (0, 0, 0, 1).
Rigid from_matrix(const double transformation[16]);

/// Tells whether a row-major 4x4 matrix is a rotation and a translation, to the precision in which
/// people write such matrices down.
bool is_rigid(const double transformation[16]);

/// The largest useful translation in the normalized frame: a larger one leaves no digits in the
/// floats that the clouds are made of.
constexpr double kFarthest = 1e6;

/// Tells whether all values are numbers of at most kFarthest.
bool is_near(const double* values, std::size_t count);

/// Returns the angle between two rotations in radians, exact for tiny angles too.
double rotation_distance(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b);

}  // namespace emtr
