#pragma once

#include <pcl/types.h>

#include <cstring>

#include "voxels/cell_grid.h"

namespace emtr {

/// Finds the neighbors of one point, as PCL's kd-tree would.
class Neighborhood {
 public:
  pcl::Indices index;  ///< rows of the cloud
  std::vector<float> squared;

  /// Selects the occupied cell whose points find() takes.
  void set_cell(const CellGrid& grid, std::size_t cell, double radius) {
    grid.around(cell, grid.reach(radius), ranges_);
    limit_ = static_cast<float>(radius * radius);
  }

  /// Finds the neighbors of sorted point i that `keep` admits, sorted by distance and then by row
  /// when `ordered`.
  template <class Keep>
  void find(const CellGrid& grid, std::size_t i, bool ordered, const Keep& keep) {
    const Cloud& p = grid.sorted;
    found_.clear();
    for (const auto& range : ranges_)
      for (std::size_t k = range.begin; k < range.end; ++k) {
        const float x = p.x[i] - p.x[k], y = p.y[i] - p.y[k], z = p.z[i] - p.z[k];
        const float distance = (x * x + y * y) + z * z;
        if (distance < limit_ && keep(k)) found_.push_back(key(distance, grid.rows[k]));
      }
    if (ordered) std::sort(found_.begin(), found_.end());
    index.resize(found_.size());
    squared.resize(found_.size());
    for (std::size_t k = 0; k < found_.size(); ++k) {
      index[k] = static_cast<pcl::index_t>(found_[k] & 0xffffffffu);
      const auto bits = static_cast<std::uint32_t>(found_[k] >> 32);
      std::memcpy(&squared[k], &bits, sizeof bits);
    }
  }

 private:
  /// Packs both into a sortable number: the bits of distances, which are not negative, have the
  /// order of the distances.
  static std::uint64_t key(float distance, std::int32_t row) {
    std::uint32_t bits;
    std::memcpy(&bits, &distance, sizeof bits);
    return std::uint64_t{bits} << 32 | static_cast<std::uint32_t>(row);
  }

  std::vector<CellGrid::Range> ranges_;
  std::vector<std::uint64_t> found_;
  float limit_ = 0;
};

}  // namespace emtr
