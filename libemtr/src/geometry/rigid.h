#pragma once

#include <cstddef>

namespace emtr {

/// q = R p + t. R row-major.
struct Rigid {
  double R[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  double t[3] = {0, 0, 0};

  Rigid inverse() const {
    Rigid out;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) out.R[3 * i + j] = R[3 * j + i];
      out.t[i] = -(R[i] * t[0] + R[3 + i] * t[1] + R[6 + i] * t[2]);
    }
    return out;
  }
};

/// Between a pose and a row-major 4x4, of which the last row is taken to be (0, 0, 0, 1).
void to_matrix(const Rigid& pose, double transformation[16]);
Rigid from_matrix(const double transformation[16]);

/// Whether a row-major 4x4 is a rotation and a translation, to the precision in which people
/// write such matrices down.
bool is_rigid(const double transformation[16]);

/// Beyond this a translation in the normalized frame has no digits left in the floats that the
/// clouds are made of.
constexpr double kFarthest = 1e6;

/// Whether all are numbers no larger than that.
bool is_near(const double* values, std::size_t count);

/// Angle between two rotations in radians, exact for tiny angles too.
double rotation_distance(const double* Ra, const double* Rb);

}  // namespace emtr
