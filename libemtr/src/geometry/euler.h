#pragma once

#include "geometry/rigid.h"

namespace emtr {

/// Returns the rotation of Z-Y-X Euler angles about fixed axes, R = Rz(theta1) Ry(theta2)
/// Rx(theta3). Takes any real angles: a particle may leave the canonical ranges, R is periodic.
Eigen::Matrix3d euler_to_rotation(const double angles[3]);

/// Writes the canonical angles, theta1 and theta3 in [-pi, pi], theta2 in [-pi/2, pi/2]; theta3 = 0 at the
/// gimbal lock.
void rotation_to_euler(const Eigen::Matrix3d& R, double angles[3]);

/// Of all angles for the same rotation the ones nearest to `reference`, so that a mean of the two
/// lies between the two rotations.
void nearest_alias(const double angles[3], const double reference[3], double out[3]);

/// A particle of task alpha (theta1, theta2, theta3, tx, ty, tz) as a pose, and back.
Rigid decode(const double particle[6]);
void encode(const Rigid& pose, double particle[6]);

}  // namespace emtr
