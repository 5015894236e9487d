#include "ranking/z_buffer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "geometry/transform.h"
#include "ranking/cube_map.h"

namespace emtr {
namespace {

constexpr float kMinimumCosine =
    0.1f;  // a surface seen more askance falls away no further than at this

double mean(const std::vector<float>& v) {
  return std::accumulate(v.begin(), v.end(), 0.0) / static_cast<double>(v.size());
}

}  // namespace

ZBuffer::ZBuffer(const Surface& surface, double bin, const Kernels& kernels)
    : surface_(surface),
      bin_width_(bin * surface.leaf),
      kernels_(kernels),
      centroid_{mean(surface.points.x), mean(surface.points.y), mean(surface.points.z)} {
  for (auto* v : {&x_, &y_, &z_, &range_, &allowance_}) v->resize(surface.points.size());
  place_.resize(surface.points.size());
  bin_.resize(surface.points.size());
}

void ZBuffer::measure(const double viewpoint[3]) {
  const Cloud &p = surface_.points, &n = surface_.normals;
  const auto leaf = static_cast<float>(surface_.leaf), bin = static_cast<float>(bin_width_);
  const auto x = static_cast<float>(viewpoint[0]), y = static_cast<float>(viewpoint[1]),
             z = static_cast<float>(viewpoint[2]);
  for (std::size_t i = 0; i < p.size(); ++i) {
    const float dx = p.x[i] - x, dy = p.y[i] - y, dz = p.z[i] - z;
    const float range = std::sqrt((dx * dx + dy * dy) + dz * dz);
    const float along = std::abs((dx * n.x[i] + dy * n.y[i]) + dz * n.z[i]);
    // A point without a normal (NaN) fails the comparison, and is taken to face the viewpoint.
    float cosine = along < range ? along / range : 1.0f;
    cosine = cosine > kMinimumCosine ? cosine : kMinimumCosine;
    range_[i] = range;
    allowance_[i] = leaf + bin * std::sqrt(1 / (cosine * cosine) - 1);
  }
}

std::size_t ZBuffer::find_bins(const DirectionBins& bins) {
  const std::size_t n = surface_.points.size();
  CubeMap map(bins.side());
  for (std::size_t i = 0; i < n; ++i) {
    place_[i] = bins(x_[i], y_[i], z_[i]);
    map.include(place_[i]);
  }
  const std::size_t count = map.number_bins();
  for (std::size_t i = 0; i < n; ++i) bin_[i] = static_cast<std::uint32_t>(map.index(place_[i]));
  return count;
}

double ZBuffer::visible_share(const double viewpoint[3]) {
  const Cloud& points = surface_.points;
  const std::size_t n = points.size();
  measure(viewpoint);
  const DirectionBins bins(viewpoint, centroid_.data(),
                           bin_width_ / std::max(mean(range_), bin_width_));
  transform(kernels_, points, bins.to_view(), x_.data(), y_.data(), z_.data());
  const std::size_t count = find_bins(bins);
  if (nearest_.size() < count) nearest_.resize(count);
  for (std::size_t i = 0; i < n; ++i) nearest_[bin_[i]] = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < n; ++i) nearest_[bin_[i]] = std::min(nearest_[bin_[i]], range_[i]);
  std::size_t seen = 0;
  for (std::size_t i = 0; i < n; ++i) seen += range_[i] <= nearest_[bin_[i]] + allowance_[i];
  return static_cast<double>(seen) / static_cast<double>(n);
}

}  // namespace emtr
