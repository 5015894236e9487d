#pragma once

namespace emtr {

/// How the three Euler angles of a particle (see geometry/euler.h) move: each angle by itself, as
/// in the paper, or together by a rotation vector, in the tangent space of SO(3).
enum class RotationSteps { Angles, Vector };

/// Writes the rotation vector of the shortest arc: exp(vector) R(from) = R(to).
void rotation_between(const double from[3], const double to[3], double vector[3]);

/// Replaces angles by the canonical angles of exp(vector) R(angles).
void rotate_angles(double angles[3], const double vector[3]);

}  // namespace emtr
