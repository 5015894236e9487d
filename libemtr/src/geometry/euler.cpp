#include "geometry/euler.h"

#include <algorithm>
#include <cmath>

namespace emtr {
namespace {

constexpr double kPi = 3.14159265358979323846;

double nearest_turn(double angle, double reference) {
  return angle + 2 * kPi * std::round((reference - angle) / (2 * kPi));
}

}  // namespace

void euler_to_rotation(const double angles[3], double R[9]) {
  const double c1 = std::cos(angles[0]), s1 = std::sin(angles[0]);
  const double c2 = std::cos(angles[1]), s2 = std::sin(angles[1]);
  const double c3 = std::cos(angles[2]), s3 = std::sin(angles[2]);
  R[0] = c1 * c2;
  R[1] = c1 * s2 * s3 - s1 * c3;
  R[2] = c1 * s2 * c3 + s1 * s3;
  R[3] = s1 * c2;
  R[4] = s1 * s2 * s3 + c1 * c3;
  R[5] = s1 * s2 * c3 - c1 * s3;
  R[6] = -s2;
  R[7] = c2 * s3;
  R[8] = c2 * c3;
}

void rotation_to_euler(const double R[9], double angles[3]) {
  const double cosine = std::hypot(R[0], R[3]);
  angles[1] = std::atan2(-R[6], cosine);
  if (cosine > 1e-12) {
    angles[0] = std::atan2(R[3], R[0]);
    angles[2] = std::atan2(R[7], R[8]);
  } else {
    angles[0] = std::atan2(-R[1], R[4]);
    angles[2] = 0;
  }
}

void nearest_alias(const double angles[3], const double reference[3], double out[3]) {
  const double aliases[2][3] = {{angles[0], angles[1], angles[2]},
                                {angles[0] + kPi, kPi - angles[1], angles[2] + kPi}};
  double best = HUGE_VAL;
  for (const auto& alias : aliases) {
    double turned[3], distance = 0;
    for (int i = 0; i < 3; ++i) {
      turned[i] = nearest_turn(alias[i], reference[i]);
      distance += (turned[i] - reference[i]) * (turned[i] - reference[i]);
    }
    if (distance < best) {
      best = distance;
      std::copy_n(turned, 3, out);
    }
  }
}

Rigid decode(const double particle[6]) {
  Rigid pose;
  euler_to_rotation(particle, pose.R);
  std::copy_n(particle + 3, 3, pose.t);
  return pose;
}

void encode(const Rigid& pose, double particle[6]) {
  rotation_to_euler(pose.R, particle);
  std::copy_n(pose.t, 3, particle + 3);
}

}  // namespace emtr
