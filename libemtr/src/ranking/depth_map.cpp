#include "ranking/depth_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "geometry/transform.h"
#include "kernels/search_kernels.h"

namespace emtr {
namespace {

constexpr float kMargin = 0.7f;  // leaves, to be clearly in front
constexpr int kMinimumFilled = 6;
constexpr std::size_t kPiece = 256;  // points whose bins are found at once
constexpr float kEmpty = std::numeric_limits<float>::infinity();

void move(const Kernels& kernels, const Cloud& points, const Rigid& pose, DepthMap::Scratch& s) {
  if (s.x.size() < points.size() + kPiece)
    for (auto* v : {&s.x, &s.y, &s.z}) v->resize(points.size() + kPiece);
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
    : kernels_(kernels), bins_(make_bins(points, viewpoint, leaf)), map_(bins_.side()) {
  Scratch s;
  move(kernels, points, bins_.to_view(), s);
  Bins bins(points.size());
  std::vector<float> ranges(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    bins[i] = bins_(s.x[i], s.y[i], s.z[i]);
    map_.include(bins[i]);
    ranges[i] = std::sqrt((s.x[i] * s.x[i] + s.y[i] * s.y[i]) + s.z[i] * s.z[i]);
  }
  squared_free_range_.assign(map_.number_bins(), 0);
  const std::vector<float> nearest = nearest_ranges(bins, ranges);
  for (std::int32_t face = 0; face < 6; ++face)
    find_free_ranges(map_.window(face), nearest, kMargin * static_cast<float>(leaf));
}

std::vector<float> DepthMap::nearest_ranges(const Bins& bins,
                                            const std::vector<float>& ranges) const {
  std::vector<float> nearest(squared_free_range_.size(), kEmpty);
  for (std::size_t i = 0; i < bins.size(); ++i) {
    float& range = nearest[map_.index(bins[i])];
    range = std::min(range, ranges[i]);
  }
  return nearest;
}

void DepthMap::find_free_ranges(const CubeMap::Window& w, const std::vector<float>& nearest,
                                float margin) {
  for (std::int32_t row = w.top; row <= w.bottom; ++row)
    for (std::int32_t column = w.left; column <= w.right; ++column) {
      int filled = 0;
      float minimum = kEmpty;
      for (std::int32_t r = std::max(row - 1, w.top); r <= std::min(row + 1, w.bottom); ++r)
        for (std::int32_t c = std::max(column - 1, w.left); c <= std::min(column + 1, w.right);
             ++c) {
          const float range = nearest[w.index(c, r)];
          filled += range < kEmpty;
          minimum = std::min(minimum, range);
        }
      const float free = minimum - margin;
      if (filled >= kMinimumFilled && free > 0)
        squared_free_range_[w.index(column, row)] = free * free;
    }
}

std::size_t DepthMap::in_front(const Cloud& points, const Rigid& pose, Scratch& s,
                               const std::uint8_t* inlier) const {
  move(kernels_, points, bins_.to_view() * pose, s);
  std::int32_t face[kPiece], column[kPiece], row[kPiece];
  std::size_t count = 0;
  for (std::size_t first = 0; first < points.size(); first += kPiece) {
    const float *x = &s.x[first], *y = &s.y[first], *z = &s.z[first];
    const std::size_t n = std::min(kPiece, points.size() - first);
    search_kernels(kernels_).direction_bins({x, y, z, n}, bins_.half_side(), {face, column, row});
    // No branches: which way they go is a toss-up.
    for (std::size_t k = 0; k < n; ++k) {
      const DirectionBins::Bin bin = {face[k], std::min(column[k], bins_.side() - 1),
                                      std::min(row[k], bins_.side() - 1)};
      const CubeMap::Window& w = map_.window(bin.face);
      const bool asked = !(inlier && inlier[first + k]) & w.contains(bin);
      const float squared = (x[k] * x[k] + y[k] * y[k]) + z[k] * z[k];
      count += asked & (squared < squared_free_range_[asked ? w.index(bin.column, bin.row) : 0]);
    }
  }
  return count;
}

}  // namespace emtr
