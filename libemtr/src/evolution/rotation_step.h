#pragma once

namespace emtr {

/// How the three Euler angles of a particle (see tasks/euler.h) are moved: each angle by itself, as
/// in the paper, or the rotation by a rotation vector, in the tangent space of SO(3).
enum class RotationSteps { Angles, Vector };

/// The rotation vector of the shortest arc, on the left: exp(vector) R(from) = R(to).
void rotation_between(const double from[3], const double to[3], double vector[3]);

/// exp(vector) R(angles), as canonical angles.
void rotate_angles(double angles[3], const double vector[3]);

}  // namespace emtr
