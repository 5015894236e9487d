#pragma once

#include <array>
#include <cstddef>
#include <optional>

namespace emtr {

/// Counts the points of a cloud by their distance from its centroid, in bins half an octave wide,
/// to find those that are clearly separated from all the others.
class DistanceHistogram {
 public:
  void add(double squared_distance) { ++counts_[bin(squared_distance)]; }
  void add(const DistanceHistogram& other);

  /// Returns the squared distance from which on all points are strays. Nothing if there are none
  /// or if more than `most` points would be.
  std::optional<double> find_strays(std::size_t most) const;

 private:
  static std::size_t bin(double squared_distance);

  static constexpr int kLowest = -640, kHighest = 63;  // powers of two of a squared distance
  std::array<std::size_t, kHighest - kLowest + 1> counts_{};
};

/// Returns how many of so many points may be strays: 1 %, or none if the points are too few to say.
std::size_t most_strays(std::size_t points);

/// Tells whether a cloud may have strays at all: without them no point of a surface is many times
/// as far from the centroid as the root mean square.
bool may_have_strays(double squared_radius, double mean_squared_distance);

}  // namespace emtr
