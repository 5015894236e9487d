#include "neighbors/cells.h"

#include <algorithm>
#include <cmath>

#include "geometry/range.h"

namespace emtr {
namespace {

/// With more cells along one axis, rounding would take too large a share of a cell.
constexpr std::int32_t kMaximumAlong = 8192;

}  // namespace

CellLayout make_cell_layout(const Cloud& cloud, float radius, float border, float cell,
                            double max_cells) {
  CellLayout out = {};
  const std::vector<float>* axes[3] = {&cloud.x, &cloud.y, &cloud.z};
  float extent[3], largest = 0;
  for (int a = 0; a < 3; ++a) {
    const auto [low, high] = range_of(*axes[a]);
    out.view.origin[a] = low - border;
    extent[a] = high + border - out.view.origin[a];
    largest = std::max({largest, std::abs(low - border), std::abs(high + border)});
  }
  std::int32_t along;
  for (;; cell *= 1.25f) {
    double cells = 1;
    along = 1;
    for (int a = 0; a < 3; ++a) {
      const float size = std::min(std::floor(extent[a] / cell), static_cast<float>(kMaximumAlong));
      out.view.size[a] = static_cast<std::int32_t>(size) + 1;
      along = std::max(along, out.view.size[a]);
      cells *= out.view.size[a];
    }
    if (cells <= max_cells && along <= kMaximumAlong) break;
  }
  out.view.inverse_cell = 1.0f / cell;
  out.view.limit = radius * radius;
  out.cell = cell;
  // Rounds a position in cells to a share of itself, and a coordinate to a share of its own size.
  out.margin = 1e-4f + 1e-6f * static_cast<float>(along) + 1e-6f * largest / cell;
  return out;
}

void Occupancy::count() {
  size_ = 0;
  for (CellGroup& group : groups_) {
    group.before = static_cast<std::uint32_t>(size_);
    size_ += static_cast<std::size_t>(__builtin_popcount(group.occupied));
  }
}

}  // namespace emtr
