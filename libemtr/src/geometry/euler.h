#pragma once

#include "geometry/rigid.h"

namespace emtr {

/// Returns the rotation of Z-Y-X Euler angles about fixed axes, R = Rz(theta1) Ry(theta2)
/// Rx(theta3). Takes any real angles: a particle may leave the canonical ranges, R is periodic.
Eigen::Matrix3d euler_to_rotation(const double angles[3]);

/// Writes the canonical angles: theta1 and theta3 in [-pi, pi], theta2 in [-pi/2, pi/2]. At the
/// gimbal lock theta3 is 0.
void rotation_to_euler(const Eigen::Matrix3d& R, double angles[3]);

/// Writes the angles of the same rotation that are nearest to `reference`, so that a mean of the
/// two lies between the two rotations.
void nearest_alias(const double angles[3], const double reference[3], double out[3]);

/// Returns the pose of a particle of task alpha: (theta1, theta2, theta3, tx, ty, tz).
Rigid decode(const double particle[6]);
/// Writes the particle of a pose.
void encode(const Rigid& pose, double particle[6]);

}  // namespace emtr
