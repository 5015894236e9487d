#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "preprocessing/ball.h"
#include "preprocessing/cloud_reader.h"

namespace emtr {

/// Where a cloud lies and how far it reaches, in the user's unit. Strays are left out everywhere.
struct Extent {
  std::vector<std::size_t> finite;  ///< points of each block of the reader
  std::size_t count = 0;            ///< of all finite points but the strays
  std::size_t strays = 0;           ///< finite points far outside of all the others
  std::optional<Ball> without_strays;
  double center[3] = {};  ///< centroid
  double radius = 0;      ///< largest distance from it
  int longest = 0;        ///< the axis along which the cloud varies most

  void to_unit_ball(const double p[3], float out[3]) const {
    const double inverse = 1 / radius;
    for (int k = 0; k < 3; ++k) out[k] = static_cast<float>((p[k] - center[k]) * inverse);
  }
};

/// What a cloud must have to be a surface; three points, with matches, have a pose.
constexpr std::size_t kSurfacePoints = 10, kMatchedPoints = 3;

/// Measures a cloud in two passes, in double; in two more for each time that strays are found, so
/// that those still farther away hide none. Throws Error, naming the cloud, when it has fewer
/// than `minimum` finite points, all of them on one point or one line, or coordinates too large to
/// square.
Extent measure_extent(const CloudReader& reader, const std::string& name, int threads,
                      std::size_t minimum = kSurfacePoints);

}  // namespace emtr
