#include "html/point_block.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "failure.h"
#include "html/base64.h"
#include "read/vector_field.h"

namespace cli {
namespace {

using Point = std::array<double, 3>;
using Steps = std::array<std::uint64_t, 3>;

constexpr std::uint64_t kLevels = 65535;
constexpr std::size_t kLookedAt = 8;  // times as many points as are shown are spread in space

/// Returns the finite points that are no strays.
std::vector<Point> inside(const CloudFile& cloud, const double (&center)[3], double radius) {
  const VectorField field = require_vector(cloud, {"x", "y", "z"});
  const Eigen::Vector3d middle = Eigen::Vector3d::Map(center);
  const bool known = middle.allFinite() && std::isfinite(radius) && radius > 0;
  const double bound = radius * (1 + 1e-6);
  std::vector<Point> out;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d p = field.get(cloud.blob.data.data() + i * cloud.blob.point_step);
    if (!p.allFinite()) continue;
    const double x = p[0] - middle[0], y = p[1] - middle[1], z = p[2] - middle[2];
    if (!known || x * x + y * y + z * z <= bound * bound) out.push_back({p[0], p[1], p[2]});
  }
  return out;
}

/// Returns the number with its digits mixed, so that neighbors have nothing in common.
std::uint32_t mixed(std::uint32_t number) {
  for (const std::uint32_t factor : {0x7FEB352DU, 0x846CA68BU})
    number = (number ^ (number >> 16)) * factor;
  return number ^ (number >> 16);
}

/// Keeps one point somewhere in each of `wanted` parts of the rows: equal gaps would show as
/// stripes in scans that are grids.
std::vector<Point> jittered(std::vector<Point> points, std::size_t wanted) {
  const std::uint64_t count = points.size();
  if (count <= wanted) return points;
  std::vector<Point> out(wanted);
  for (std::uint64_t i = 0; i < wanted; ++i) {
    const std::uint64_t place = (i << 8) + (mixed(static_cast<std::uint32_t>(i)) >> 24);
    out[i] = points[place * count / (static_cast<std::uint64_t>(wanted) << 8)];
  }
  return out;
}

/// Returns rows by the cell that each is in, the first row of each cell first.
std::vector<std::pair<std::uint64_t, std::size_t>> by_cell(const std::vector<Steps>& steps,
                                                           std::uint64_t size) {
  std::vector<std::pair<std::uint64_t, std::size_t>> cells(steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i)
    cells[i] = {steps[i][0] / size << 32 | steps[i][1] / size << 16 | steps[i][2] / size, i};
  std::sort(cells.begin(), cells.end());
  const auto same = [](const auto& a, const auto& b) { return a.first == b.first; };
  cells.erase(std::unique(cells.begin(), cells.end(), same), cells.end());
  return cells;
}

/// Returns ascending rows, at most `wanted`: the first of each cell of the finest grid, by a whole
/// number of steps, that has no more cells than that.
std::vector<std::size_t> spread_rows(const std::vector<Steps>& steps, std::size_t wanted) {
  std::uint64_t low = 1, high = kLevels + 1;
  while (low < high) {
    const std::uint64_t middle = (low + high) / 2;
    if (by_cell(steps, middle).size() <= wanted)
      high = middle;
    else
      low = middle + 1;
  }
  std::vector<std::size_t> rows;
  for (const auto& cell : by_cell(steps, low)) rows.push_back(cell.second);
  std::sort(rows.begin(), rows.end());
  return rows;
}

/// Sets the origin and the step so that the steps of all points fit 16 bits.
void measure(const std::vector<Point>& points, PointBlock& block) {
  double extent = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Point& p : points) {
      low = std::min(low, p[axis]);
      high = std::max(high, p[axis]);
    }
    block.origin[axis] = low;
    extent = std::max(extent, high - low);
  }
  block.step = extent / static_cast<double>(kLevels);
  if (!(block.step > 0)) block.step = 1;
}

}  // namespace

PointBlock point_block(const CloudFile& cloud, const double (&center)[3], double radius,
                       std::size_t most) {
  const std::vector<Point> chosen = jittered(inside(cloud, center, radius), kLookedAt * most);
  if (chosen.empty()) throw FileFailure(cloud.path, "has no finite points to show");
  PointBlock block;
  block.total = cloud.size();
  measure(chosen, block);
  std::vector<Steps> steps(chosen.size());
  for (std::size_t i = 0; i < chosen.size(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double at = std::floor((chosen[i][axis] - block.origin[axis]) / block.step + 0.5);
      steps[i][axis] = static_cast<std::uint64_t>(std::clamp(at, 0.0, double{kLevels}));
    }
  for (const std::size_t row : spread_rows(steps, most)) {
    block.points.push_back(chosen[row]);
    for (const std::uint64_t step : steps[row])
      block.steps.push_back(static_cast<std::uint16_t>(step));
  }
  return block;
}

Json PointBlock::json() const {
  return {{"total", total},
          {"shown", points.size()},
          {"origin", origin},
          {"step", step},
          {"points", base64(steps)}};
}

}  // namespace cli
