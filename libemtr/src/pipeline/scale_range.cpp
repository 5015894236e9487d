#include "pipeline/scale_range.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "settings/choices.h"
#include "voxels/voxel_grid.h"

namespace emtr {
namespace {

constexpr double kReach = 2;            // octaves on either side of the guess
constexpr float kEvenlySpread = 0.05f;  // radii, of a voxel: points count by the area they cover
constexpr double kUnits[] = {1, 10, 12, 25.4, 100, 304.8, 1000};

/// Returns the root mean square distance from the centroid of what the cloud covers, user's unit.
double covered_radius(const PreprocessedCloud& cloud) {
  const Cloud points = voxel_grid(cloud.base, kEvenlySpread);
  const auto n = static_cast<double>(points.size());
  double mean[3] = {}, squares = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double p[3] = {double{points.x[i]}, double{points.y[i]}, double{points.z[i]}};
    for (std::size_t a = 0; a < 3; ++a) {
      mean[a] += p[a] / n;
      squares += p[a] * p[a] / n;
    }
  }
  for (const double m : mean) squares -= m * m;
  return std::sqrt(std::max(squares, 0.0)) * cloud.radius;
}

}  // namespace

double ScaleRange::scale(double octaves) const { return guess * std::exp2(octaves); }
double ScaleRange::octaves(double scale) const { return std::log2(scale / guess); }

ScaleRange scale_range(const PreprocessedCloud& source, const PreprocessedCloud& target,
                       const Settings& settings) {
  ScaleRange out{covered_radius(target) / covered_radius(source), -kReach, kReach};
  if (!(settings.scale == ScaleSearched::Bounded)) return out;
  const double low = out.octaves(settings.scale_minimum),
               high = out.octaves(settings.scale_maximum);
  // Takes the nearest of bounds that hold nothing likely.
  out.lowest = std::max(low, std::min(-kReach, high - 2 * kReach));
  out.highest = std::min(high, std::max(kReach, low + 2 * kReach));
  return out;
}

std::vector<double> unit_factors(const ScaleRange& range) {
  std::vector<double> all, out;
  for (const double unit : kUnits) {
    all.push_back(unit);
    if (unit != 1) all.push_back(1 / unit);
  }
  const auto far = [&](double unit) { return std::abs(range.octaves(unit)); };
  std::sort(all.begin(), all.end(), [&](double a, double b) { return far(a) < far(b); });
  std::copy_if(all.begin(), all.end(), std::back_inserter(out),
               [&](double unit) { return far(unit) <= kReach; });
  return out.empty() ? std::vector<double>{all.front()} : out;
}

}  // namespace emtr
