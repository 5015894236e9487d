#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/cloud.h"

namespace emtr {

/// The layout of a regular grid around a cloud.
struct CellLayout {
  CellsView view;
  float cell;    ///< side, as requested or larger
  float margin;  ///< in cells: how far rounding can move a point at most
};

/// Returns the cells of the cloud's bounding box and of a border around it. Enlarges the side from
/// `cell` until there are at most `max_cells`.
CellLayout make_cell_layout(const Cloud& cloud, float radius, float border, float cell,
                            double max_cells);

/// A bit for each cell that is occupied, and the number of occupied cells before each group.
class Occupancy {
 public:
  explicit Occupancy(std::size_t cells) : groups_(cells / 32 + 1, CellGroup{0, 0}) {}

  void set(std::size_t cell) { groups_[cell / 32].occupied |= std::uint32_t{1} << (cell % 32); }
  void count();  ///< after the last set()

  std::size_t size() const { return size_; }  ///< number of cells that are set
  /// Returns the number of cells set before this one: its own place if it is set.
  std::size_t before(std::size_t cell) const {
    const CellGroup& group = groups_[cell / 32];
    const std::uint32_t below = group.occupied & ((std::uint32_t{1} << (cell % 32)) - 1);
    return group.before + static_cast<std::size_t>(__builtin_popcount(below));
  }
  const CellGroup* groups() const { return groups_.data(); }

  /// Calls visit(cell) for each that is set, in order.
  template <class Visit>
  void for_each(Visit visit) const {
    for (std::size_t g = 0; g < groups_.size(); ++g)
      for (std::uint32_t left = groups_[g].occupied; left != 0; left &= left - 1)
        visit(g * 32 + static_cast<std::size_t>(__builtin_ctz(left)));
  }

 private:
  std::vector<CellGroup> groups_;
  std::size_t size_ = 0;
};

}  // namespace emtr
