#include "geometry/euler.h"

#include <algorithm>
#include <cmath>

#include "util/constants.h"

namespace emtr {
namespace {

double nearest_equivalent(double angle, double reference) {
  return angle + 2 * kPi * std::round((reference - angle) / (2 * kPi));
}

}  // namespace

Eigen::Matrix3d euler_to_rotation(const double angles[3]) {
  const double c1 = std::cos(angles[0]), s1 = std::sin(angles[0]);
  const double c2 = std::cos(angles[1]), s2 = std::sin(angles[1]);
  const double c3 = std::cos(angles[2]), s3 = std::sin(angles[2]);
  Eigen::Matrix3d R;
  R << c1 * c2, c1 * s2 * s3 - s1 * c3, c1 * s2 * c3 + s1 * s3,  //
      s1 * c2, s1 * s2 * s3 + c1 * c3, s1 * s2 * c3 - c1 * s3,   //
      -s2, c2 * s3, c2 * c3;
  return R;
}

void rotation_to_euler(const Eigen::Matrix3d& R, double angles[3]) {
  const double cosine = std::hypot(R(0, 0), R(1, 0));
  angles[1] = std::atan2(-R(2, 0), cosine);
  if (cosine > 1e-12) {
    angles[0] = std::atan2(R(1, 0), R(0, 0));
    angles[2] = std::atan2(R(2, 1), R(2, 2));
  } else {
    angles[0] = std::atan2(-R(0, 1), R(1, 1));
    angles[2] = 0;
  }
}

void nearest_alias(const double angles[3], const double reference[3], double out[3]) {
  const double aliases[2][3] = {{angles[0], angles[1], angles[2]},
                                {angles[0] + kPi, kPi - angles[1], angles[2] + kPi}};
  double best = HUGE_VAL;
  for (const auto& alias : aliases) {
    double near[3], distance = 0;
    for (int i = 0; i < 3; ++i) {
      near[i] = nearest_equivalent(alias[i], reference[i]);
      distance += (near[i] - reference[i]) * (near[i] - reference[i]);
    }
    if (distance < best) {
      best = distance;
      std::copy_n(near, 3, out);
    }
  }
}

Rigid decode(const double particle[6]) {
  return {euler_to_rotation(particle), Eigen::Vector3d::Map(particle + 3)};
}

void encode(const Rigid& pose, double particle[6]) {
  rotation_to_euler(pose.R, particle);
  Eigen::Vector3d::Map(particle + 3) = pose.t;
}

}  // namespace emtr
