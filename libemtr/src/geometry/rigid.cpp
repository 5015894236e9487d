#include "geometry/rigid.h"

#include <algorithm>
#include <cmath>

namespace emtr {

Rigid Rigid::operator*(const Rigid& first) const {
  Rigid out;
  for (int j = 0; j < 3; ++j) out.R.col(j) = rotate(first.R.col(j));
  out.t = *this * first.t;
  return out;
}

Rigid Rigid::inverse() const {
  Rigid out;
  out.R = R.transpose();
  out.t = -out.rotate(t);
  return out;
}

void to_matrix(const Rigid& pose, double T[16]) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) T[4 * i + j] = pose.R(i, j);
    T[4 * i + 3] = pose.t[i];
    T[12 + i] = 0;
  }
  T[15] = 1;
}

Rigid from_matrix(const double T[16]) {
  Rigid pose;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) pose.R(i, j) = T[4 * i + j];
    pose.t[i] = T[4 * i + 3];
  }
  return pose;
}

bool is_rigid(const double T[16]) {
  constexpr double tolerance = 1e-3;
  for (int i = 0; i < 16; ++i)
    if (!std::isfinite(T[i])) return false;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      double dot = 0;
      for (int k = 0; k < 3; ++k) dot += T[4 * i + k] * T[4 * j + k];
      if (std::abs(dot - (i == j)) > tolerance) return false;
    }
  const double determinant = T[0] * (T[5] * T[10] - T[6] * T[9]) -
                             T[1] * (T[4] * T[10] - T[6] * T[8]) +
                             T[2] * (T[4] * T[9] - T[5] * T[8]);
  const bool last_row = std::abs(T[12]) < tolerance && std::abs(T[13]) < tolerance &&
                        std::abs(T[14]) < tolerance && std::abs(T[15] - 1) < tolerance;
  return determinant > 0 && last_row;
}

bool is_near(const double* values, std::size_t count) {
  return std::all_of(values, values + count,
                     [](double value) { return std::abs(value) <= kFarthest; });  // false for NaN
}

double rotation_distance(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  double sum = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) sum += (a(i, j) - b(i, j)) * (a(i, j) - b(i, j));
  return 2 * std::asin(std::min(1.0, std::sqrt(sum / 8)));
}

}  // namespace emtr
