#pragma once

#include "../rigid.h"

namespace emtr {

/// How far apart two poses are in the normalised frame, where a pose's t moves the source's
/// centroid: the angle between the rotations and the distance between the translations.
struct Nearness {
  double angle;   ///< radians
  double offset;  ///< radii
};

/// Poses further apart than this are different answers, not one answer found twice.
constexpr Nearness kMode = {10 * 3.14159265358979323846 / 180, 0.15};
/// Poses nearer than this end in the same place when they are polished.
constexpr Nearness kCopy = {3 * 3.14159265358979323846 / 180, 0.03};

bool within(const Rigid& a, const Rigid& b, const Nearness& limit);

}  // namespace emtr
