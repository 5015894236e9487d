#pragma once

#include <limits>

namespace emtr {

constexpr double kPi = 3.14159265358979323846;
constexpr double kDegree = kPi / 180;  ///< radians

/// Stands for the coordinates of a normal and the numbers of a descriptor that do not exist.
constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

}  // namespace emtr
