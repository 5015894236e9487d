#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/cloud.h"
#include "support/clouds.h"

namespace emtr_test {

/// Points of a street and the normals there, in units of 30 m.
struct StreetScan {
  emtr::Cloud points, normals;
};

/// Scans a street with a wall beside it by a LiDAR of 16 rings at the origin, `steps` rays a ring.
inline StreetScan scan_street(int steps) {
  constexpr double kUnit = 30, kGround = -1.8 / kUnit, kWall = 6 / kUnit, kHeight = 4 / kUnit;
  constexpr double kDegree = 3.14159265358979323846 / 180;
  StreetScan out;
  for (int ring = 0; ring < 16; ++ring)
    for (int step = 0; step < steps; ++step) {
      const double elevation = (-25 + ring * 40. / 15) * kDegree,
                   azimuth = 360. * step / steps * kDegree;
      const double u[3] = {std::cos(elevation) * std::cos(azimuth),
                           std::cos(elevation) * std::sin(azimuth), std::sin(elevation)};
      const double down = u[2] < 0 ? kGround / u[2] : HUGE_VAL,
                   ahead = u[0] > 0 ? kWall / u[0] : HUGE_VAL, range = std::min(down, ahead);
      if (range > 1 || range * u[2] > kHeight) continue;
      push(out.points, static_cast<float>(range * u[0]), static_cast<float>(range * u[1]),
           static_cast<float>(range * u[2]));
      push(out.normals, down < ahead ? 0.0f : 1.0f, 0.0f, down < ahead ? 1.0f : 0.0f);
    }
  return out;
}

}  // namespace emtr_test
