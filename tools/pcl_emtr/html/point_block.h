#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "read/cloud_file.h"
#include "report/json.h"

namespace cli {

/// The points of a cloud that a page shows: evenly spread in space, 16 bits a coordinate.
struct PointBlock {
  std::vector<std::array<double, 3>> points;  ///< in the cloud's frame and unit
  std::vector<std::uint16_t> steps;           ///< (n, 3): points are near origin + step * steps
  std::array<double, 3> origin{};
  double step = 1;
  std::size_t total = 0;  ///< points of the cloud

  Json json() const;
};

/// Chooses at most `most` points. Left out are points that are not finite, and strays: those
/// farther than `radius` from `center`, both of a result's normalization.
/// pyemtr/html/point_block.py does the same, to the same bits. Throws FileFailure.
PointBlock point_block(const CloudFile& cloud, const double (&center)[3], double radius,
                       std::size_t most);

}  // namespace cli
