#include "preprocessing/strays.h"

#include <algorithm>
#include <cmath>

namespace emtr {
namespace {

// Bins of a factor of sqrt(2) in distance. In scans of all kinds the farthest point is up to 2.8
// times as far away as 99 % of them, and no gap on the way is wider than a factor of 1.8.
constexpr std::size_t kFar = 4;       // bins: at least 2.8 times
constexpr std::size_t kGap = 3;       // bins: a gap of at least 2 times
constexpr std::size_t kFarthest = 7;  // bins: at least 8 times, where no gap is asked for

}  // namespace

std::size_t DistanceHistogram::bin(double squared_distance) {
  const int power = squared_distance > 0 ? std::ilogb(squared_distance) : kLowest;
  return static_cast<std::size_t>(std::clamp(power, kLowest, kHighest) - kLowest);
}

void DistanceHistogram::add(const DistanceHistogram& other) {
  for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i] += other.counts_[i];
}

std::optional<double> DistanceHistogram::find_strays(std::size_t most) const {
  // The innermost bin of which no more than `most` points lie outside.
  std::size_t inner = counts_.size(), outside = 0;
  while (inner > 0 && outside <= most) outside += counts_[--inner];
  std::size_t last = inner;
  for (std::size_t i = inner + 1; i < counts_.size(); ++i) {
    if (counts_[i] == 0) continue;
    if (i >= inner + kFarthest || (i >= inner + kFar && i >= last + kGap))
      return std::ldexp(1.0, static_cast<int>(last) + kLowest + 1);
    last = i;
  }
  return std::nullopt;
}

std::size_t most_strays(std::size_t points) {
  constexpr std::size_t enough = 25;
  return points < enough ? 0 : (points + 99) / 100;
}

bool may_have_strays(double squared_radius, double mean_squared_distance) {
  return squared_radius > 9 * mean_squared_distance;
}

}  // namespace emtr
