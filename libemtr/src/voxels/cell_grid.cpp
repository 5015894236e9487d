#include "voxels/cell_grid.h"

#include <algorithm>
#include <cmath>

#include "geometry/range.h"

namespace emtr {
namespace {

constexpr double kCellsPerPoint = 16;   // more would cost memory and time for empty space
constexpr double kMinimumCells = 4096;  // allowed for any cloud
// Distances are computed in float: a point may seem nearer than it is by this share.
constexpr double kRounding = 1e-6;

}  // namespace

CellGrid::CellGrid(const Cloud& cloud, double side) : side_(side * (1 + 4 * kRounding)) {
  const std::vector<float>* axes[3] = {&cloud.x, &cloud.y, &cloud.z};
  double low[3], extent[3];
  for (int a = 0; a < 3; ++a) {
    const auto range = cloud.size() ? range_of(*axes[a]) : emtr::Range{0, 0};
    low[a] = double{range.low};
    extent[a] = double{range.high} - low[a];
  }
  const auto cells = [&] {
    double product = 1;
    for (const double e : extent) product *= std::floor(e / side_) + 1;
    return product;
  };
  const double max_cells = kCellsPerPoint * static_cast<double>(cloud.size()) + kMinimumCells;
  while (cells() > max_cells) side_ *= 1.25;
  for (int a = 0; a < 3; ++a) size_[a] = static_cast<std::int64_t>(extent[a] / side_) + 1;

  const auto along = [&](int a, std::size_t i) {
    const auto c = static_cast<std::int64_t>((double{(*axes[a])[i]} - low[a]) / side_);
    return std::min(c, size_[a] - 1);
  };
  std::vector<std::uint32_t> cell(cloud.size());
  begin_.assign(static_cast<std::size_t>(size_[0] * size_[1] * size_[2]) + 1, 0);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    cell[i] =
        static_cast<std::uint32_t>((along(2, i) * size_[1] + along(1, i)) * size_[0] + along(0, i));
    ++begin_[cell[i] + 1];
  }
  for (std::size_t c = 0; c + 1 < begin_.size(); ++c) {
    if (begin_[c + 1] != 0) occupied_.push_back(static_cast<std::uint32_t>(c));
    begin_[c + 1] += begin_[c];
  }
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  rows.resize(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i)
    rows[next[cell[i]]++] = static_cast<std::int32_t>(i);
  sorted = cloud.select(rows);
}

bool CellGrid::spans(int reach) const { return reach >= std::max({size_[0], size_[1], size_[2]}); }

int CellGrid::reach(double radius) const {
  const double longest = static_cast<double>(std::max({size_[0], size_[1], size_[2]}));
  return static_cast<int>(std::min(std::ceil(radius * (1 + kRounding) / side_), longest));
}

void CellGrid::around(std::size_t cell, int reach, std::vector<Range>& out) const {
  out.clear();
  const std::int64_t at = occupied_[cell];
  const std::int64_t x = at % size_[0], y = at / size_[0] % size_[1], z = at / size_[0] / size_[1];
  const std::int64_t x0 = std::max<std::int64_t>(x - reach, 0),
                     x1 = std::min(x + reach, size_[0] - 1);
  for (std::int64_t k = std::max<std::int64_t>(z - reach, 0);
       k <= std::min(z + reach, size_[2] - 1); ++k)
    for (std::int64_t j = std::max<std::int64_t>(y - reach, 0);
         j <= std::min(y + reach, size_[1] - 1); ++j) {
      const auto row = static_cast<std::size_t>((k * size_[1] + j) * size_[0]);
      const std::uint32_t begin = begin_[row + static_cast<std::size_t>(x0)],
                          end = begin_[row + static_cast<std::size_t>(x1) + 1];
      if (begin == end) continue;
      if (!out.empty() && out.back().end == begin)
        out.back().end = end;
      else
        out.push_back({begin, end});
    }
}

void NeighborList::gather(const Cloud& sorted, const std::vector<CellGrid::Range>& ranges) {
  std::size_t n = 0;
  for (const auto& range : ranges) n += range.end - range.begin;
  const std::size_t size = (n + kListStep - 1) / kListStep * kListStep;
  points.resize(size);
  rows.resize(size);
  std::size_t at = 0;
  for (const auto& range : ranges) {
    const std::size_t length = range.end - range.begin;
    std::copy_n(&sorted.x[range.begin], length, &points.x[at]);
    std::copy_n(&sorted.y[range.begin], length, &points.y[at]);
    std::copy_n(&sorted.z[range.begin], length, &points.z[at]);
    for (std::size_t i = 0; i < length; ++i)
      rows[at + i] = range.begin + static_cast<std::uint32_t>(i);
    at += length;
  }
  for (; at < size; ++at) {
    points.x[at] = points.y[at] = points.z[at] = kFarAway;
    rows[at] = at > 0 ? rows[at - 1] : 0;  // ascending to the end
  }
}

}  // namespace emtr
