#include "ranking/depth_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "geometry/transform.h"

namespace emtr {
namespace {

constexpr float kMargin = 2;  // leaves, to be clearly in front
constexpr int kLeastFilled = 6;
constexpr float kEmpty = std::numeric_limits<float>::infinity();

void move(const Kernels& kernels, const Cloud& points, const Rigid& pose, DepthMap::Scratch& s) {
  if (s.x.size() < points.size())
    for (auto* v : {&s.x, &s.y, &s.z}) v->resize(points.size());
  transform(kernels, points, pose, s.x.data(), s.y.data(), s.z.data());
}

DirectionBins make_bins(const Cloud& points, const double viewpoint[3], double leaf) {
  const auto n = static_cast<double>(points.size());
  const auto mean = [n](const std::vector<float>& v) {
    return std::accumulate(v.begin(), v.end(), 0.0) / n;
  };
  const double center[3] = {mean(points.x), mean(points.y), mean(points.z)};
  std::vector<double> squared(points.size());
  for (std::size_t i = 0; i < squared.size(); ++i) {
    const double d[3] = {double{points.x[i]} - viewpoint[0], double{points.y[i]} - viewpoint[1],
                         double{points.z[i]} - viewpoint[2]};
    squared[i] = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
  }
  const auto middle = squared.begin() + static_cast<std::ptrdiff_t>(squared.size() / 2);
  std::nth_element(squared.begin(), middle, squared.end());
  return DirectionBins(viewpoint, center, leaf / std::max(std::sqrt(*middle), leaf));
}

}  // namespace

DepthMap::DepthMap(const Cloud& points, const double viewpoint[3], double leaf,
                   const Kernels& kernels)
    : kernels_(kernels), bins_(make_bins(points, viewpoint, leaf)) {
  Scratch s;
  move(kernels, points, bins_.to_view(), s);
  std::vector<DirectionBins::Bin> bins(points.size());
  std::vector<float> ranges(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    bins[i] = bins_(s.x[i], s.y[i], s.z[i]);
    ranges[i] = std::sqrt((s.x[i] * s.x[i] + s.y[i] * s.y[i]) + s.z[i] * s.z[i]);
  }
  for (std::int32_t face = 0; face < 6; ++face)
    fill(bins, ranges, face, kMargin * static_cast<float>(leaf));
}

void DepthMap::fill(const std::vector<DirectionBins::Bin>& bins, const std::vector<float>& ranges,
                    std::int32_t face, float margin) {
  std::int32_t low[2] = {bins_.side(), bins_.side()}, high[2] = {-1, -1};
  for (const auto& bin : bins) {
    if (bin.face != face) continue;
    low[0] = std::min(low[0], bin.column);
    low[1] = std::min(low[1], bin.row);
    high[0] = std::max(high[0], bin.column);
    high[1] = std::max(high[1], bin.row);
  }
  Window& w = windows_[face];
  w = {low[0], low[1], std::max(0, high[0] - low[0] + 1), std::max(0, high[1] - low[1] + 1), {}};
  const auto at = [&w](std::int32_t column, std::int32_t row) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(w.columns) +
           static_cast<std::size_t>(column);
  };
  std::vector<float> nearest(at(0, w.rows), kEmpty);
  for (std::size_t i = 0; i < bins.size(); ++i) {
    if (bins[i].face != face) continue;
    float& range = nearest[at(bins[i].column - w.left, bins[i].row - w.top)];
    range = std::min(range, ranges[i]);
  }
  w.squared.assign(nearest.size(), 0);
  for (std::int32_t row = 0; row < w.rows; ++row)
    for (std::int32_t column = 0; column < w.columns; ++column) {
      int filled = 0;
      float least = kEmpty;
      for (std::int32_t r = std::max(row - 1, 0); r <= std::min(row + 1, w.rows - 1); ++r)
        for (std::int32_t c = std::max(column - 1, 0); c <= std::min(column + 1, w.columns - 1);
             ++c) {
          filled += nearest[at(c, r)] < kEmpty;
          least = std::min(least, nearest[at(c, r)]);
        }
      const float free = least - margin;
      if (filled >= kLeastFilled && free > 0) w.squared[at(column, row)] = free * free;
    }
}

std::size_t DepthMap::in_front(const Cloud& points, const Rigid& pose, Scratch& s) const {
  move(kernels_, points, bins_.to_view() * pose, s);
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto bin = bins_(s.x[i], s.y[i], s.z[i]);
    const Window& w = windows_[bin.face];
    const std::int32_t column = bin.column - w.left, row = bin.row - w.top;
    if (column < 0 || row < 0 || column >= w.columns || row >= w.rows) continue;
    const float squared = (s.x[i] * s.x[i] + s.y[i] * s.y[i]) + s.z[i] * s.z[i];
    count +=
        squared < w.squared[static_cast<std::size_t>(row) * static_cast<std::size_t>(w.columns) +
                            static_cast<std::size_t>(column)];
  }
  return count;
}

}  // namespace emtr
