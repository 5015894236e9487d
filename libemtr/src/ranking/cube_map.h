#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "ranking/direction_bins.h"

namespace emtr {

/// Numbers the bins of a cube map that may hold something. Each face has a window, the smallest
/// rectangle about its occupied bins: a distant viewpoint has millions of bins and uses few.
class CubeMap {
 public:
  struct Window {
    std::int32_t left, top, right,
        bottom;         ///< first and last column and row; none when right < left
    std::size_t first;  ///< number of the bin at left, top

    bool contains(const DirectionBins::Bin& bin) const {
      return bin.column >= left && bin.column <= right && bin.row >= top && bin.row <= bottom;
    }
    std::size_t index(std::int32_t column, std::int32_t row) const {
      return first +
             static_cast<std::size_t>(row - top) * static_cast<std::size_t>(right - left + 1) +
             static_cast<std::size_t>(column - left);
    }
  };

  /// Has no bin yet; `side`: bins along an edge of a face. Call include() for each occupied bin and
  /// then number_bins().
  explicit CubeMap(std::int32_t side);

  void include(const DirectionBins::Bin& bin) {
    Window& w = windows_[bin.face];
    w.left = std::min(w.left, bin.column);
    w.top = std::min(w.top, bin.row);
    w.right = std::max(w.right, bin.column);
    w.bottom = std::max(w.bottom, bin.row);
  }

  /// Numbers the bins of all windows, row by row, and returns how many there are.
  std::size_t number_bins();

  const Window& window(std::int32_t face) const { return windows_[face]; }

  /// Returns the number of a bin inside its face's window.
  std::size_t index(const DirectionBins::Bin& bin) const {
    return windows_[bin.face].index(bin.column, bin.row);
  }

 private:
  Window windows_[6];
};

}  // namespace emtr
