#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/cloud.h"
#include "geometry/range.h"

namespace emtr {

/// Counts the points that voxel_grid() would make of a cloud, for many leaves in turn.
class VoxelCounter {
 public:
  /// Keeps a reference to the cloud, which must have at least one point.
  explicit VoxelCounter(const Cloud& cloud);

  std::size_t operator()(float leaf);

 private:
  const Cloud& cloud_;
  Range x_, y_, z_;
  std::vector<std::uint64_t> occupied_;  // a bit for each voxel of the cloud's bounding box
};

}  // namespace emtr
