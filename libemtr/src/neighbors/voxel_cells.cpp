#include <algorithm>
#include <vector>

#include "neighbors/cells.h"
#include "neighbors/neighbors.h"
#include "util/cancellation.h"

namespace emtr {
namespace {

constexpr double kMaximumCells = 1 << 26;  // 17 MB; the rest takes 30 to 130 bytes for each point

/// Points sorted by cells as wide as the radius, so that all points near a query lie in the 27
/// cells around it: nine rows of three, each one range of places. A cell without a point in any of
/// the 27 is not occupied; the others list where to read the ranges, eight points at a time.
class VoxelCells final : public Neighbors {
 public:
  VoxelCells(const Cloud& cloud, float radius, const Kernels& kernels) : kernels_(kernels) {
    float side = radius * (1 + 1e-3f);
    for (;;) {
      const CellLayout layout = make_cell_layout(cloud, radius, side * 1.01f, side, kMaximumCells);
      view_.cells = layout.view;
      // Two points closer than the radius must be in the same or in touching cells.
      const float minimum = radius * (1 + 4 * layout.margin);
      if (layout.cell >= minimum && side >= layout.cell) break;
      side = std::max(layout.cell, minimum * (1 + 1e-3f));
    }
    Occupancy points(cell_count());
    const std::vector<std::uint32_t> begin = sort(cloud, points);
    list(points, begin);
    view_.cells.groups = occupied_.groups();
    view_.begin = begin_.data();
    view_.starts = starts_.data();
    view_.x = sorted_.x.data();
    view_.y = sorted_.y.data();
    view_.z = sorted_.z.data();
    view_.index = index_.data();
  }

  void squared_distances(const PointsView& queries, float* out) const override {
    kernels_.voxel_squared_distances(view_, queries, out);
  }

  void nearest(const PointsView& queries, std::int32_t* index, float* squared) const override {
    kernels_.voxel_nearest(view_, queries, index, squared);
  }

 private:
  std::size_t along(int axis) const { return static_cast<std::size_t>(view_.cells.size[axis]); }
  std::size_t cell_count() const { return along(0) * along(1) * along(2); }

  std::size_t cell_of(float x, float y, float z) const {
    const float p[3] = {x, y, z};
    std::size_t at[3];
    for (int a = 0; a < 3; ++a) {  // as the kernels do it
      const float where = (p[a] - view_.cells.origin[a]) * view_.cells.inverse_cell;
      at[a] = static_cast<std::size_t>(
          std::clamp(where, 0.0f, static_cast<float>(view_.cells.size[a] - 1)));
    }
    return (at[2] * along(1) + at[1]) * along(0) + at[0];
  }

  /// Sorts the points by cell and then by row; returns where each cell begins.
  std::vector<std::uint32_t> sort(const Cloud& cloud, Occupancy& points) {
    const std::size_t n = cloud.size();
    std::vector<std::uint32_t> cell(n);
    for (std::size_t i = 0; i < n; ++i) {
      check_cancelled_each(i, 12);
      cell[i] = static_cast<std::uint32_t>(cell_of(cloud.x[i], cloud.y[i], cloud.z[i]));
      points.set(cell[i]);
    }
    points.count();
    std::vector<std::uint32_t> begin(points.size() + 2, 0);
    for (std::uint32_t& c : cell) {
      c = static_cast<std::uint32_t>(points.before(c));
      ++begin[c + 2];
    }
    for (std::size_t k = 2; k < begin.size(); ++k) begin[k] += begin[k - 1];
    index_.resize(n);
    for (std::size_t i = 0; i < n; ++i) index_[begin[cell[i] + 1]++] = static_cast<std::int32_t>(i);
    sorted_ = cloud.select(index_);
    for (auto* axis : {&sorted_.x, &sorted_.y, &sorted_.z}) axis->resize(n + kLanes, kFarAway);
    index_.resize(n + kLanes, -1);
    begin.pop_back();
    return begin;
  }

  /// Calls visit(first cell of the row, how many) for the nine rows around a cell, in order.
  template <class Visit>
  void for_each_row(std::size_t cell, Visit visit) const {
    const std::size_t x = cell % along(0), y = cell / along(0) % along(1),
                      z = cell / along(0) / along(1);
    const auto low = [](std::size_t i) { return i > 0 ? i - 1 : 0; };
    const auto high = [&](std::size_t i, int axis) { return std::min(i + 1, along(axis) - 1); };
    for (std::size_t k = low(z); k <= high(z, 2); ++k)
      for (std::size_t j = low(y); j <= high(y, 1); ++j)
        visit((k * along(1) + j) * along(0) + low(x), high(x, 0) - low(x) + 1);
  }

  void list(const Occupancy& points, const std::vector<std::uint32_t>& begin) {
    occupied_ = Occupancy(cell_count());
    std::size_t step = 0;
    points.for_each([&](std::size_t cell) {
      check_cancelled_each(++step, 10);
      for_each_row(cell, [&](std::size_t first, std::size_t n) {
        for (std::size_t i = 0; i < n; ++i) occupied_.set(first + i);
      });
    });
    occupied_.count();
    begin_.reserve(occupied_.size() + 1);
    occupied_.for_each([&](std::size_t cell) {
      check_cancelled_each(++step, 10);
      begin_.push_back(static_cast<std::uint32_t>(starts_.size()));
      std::uint32_t read = 0;  // places before this one need no more reading
      for_each_row(cell, [&](std::size_t first, std::size_t n) {
        const std::uint32_t end = begin[points.before(first + n)];
        std::uint32_t at = std::max(read, begin[points.before(first)]);
        for (; at < end; at += kStep) starts_.push_back(at);
        read = std::max(read, at);
      });
    });
    begin_.push_back(static_cast<std::uint32_t>(starts_.size()));
  }

  static constexpr auto kStep = static_cast<std::uint32_t>(kLanes);

  const Kernels& kernels_;
  VoxelView view_{};
  Occupancy occupied_{0};  // cells with a point in one of the 27 around
  std::vector<std::uint32_t>
      begin_;  // where the starts of each of those begin, and one past the last
  std::vector<std::uint32_t> starts_;  // places where eight points are read
  Cloud sorted_;                       // the points in their places, and padding
  std::vector<std::int32_t> index_;    // their rows in the cloud
};

}  // namespace

std::unique_ptr<Neighbors> make_voxel_cells(const Cloud& cloud, float radius,
                                            const Kernels& kernels) {
  return std::make_unique<VoxelCells>(cloud, radius, kernels);
}

}  // namespace emtr
