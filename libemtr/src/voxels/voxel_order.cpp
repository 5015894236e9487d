#include "voxels/voxel_order.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "util/cancellation.h"

namespace emtr {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
constexpr double kCancelled = 0.1;  // a mean of unit vectors that is shorter has no direction
constexpr int kBits = 21;           // of a key, for each axis

std::int64_t cell(float v, float inverse) {
  return static_cast<std::int64_t>(std::floor(v * inverse));
}

double to_centre(const Cloud& cloud, std::size_t i, float leaf) {
  const float inverse = 1.0f / leaf;
  const auto off = [&](float v) {
    return double{v} - (static_cast<double>(cell(v, inverse)) + 0.5) * double{leaf};
  };
  const double x = off(cloud.x[i]), y = off(cloud.y[i]), z = off(cloud.z[i]);
  return x * x + y * y + z * z;
}

}  // namespace

/// Least significant digit first.
void sort_by_voxel(std::vector<VoxelRow>& items, std::uint64_t most) {
  constexpr int digit = 11;
  std::vector<VoxelRow> other(items.size());
  for (int shift = 0; shift < 64 && (most >> shift); shift += digit) {
    check_cancelled();  // a pass over a million items takes some milliseconds
    const auto bucket = [shift](const VoxelRow& item) {
      return static_cast<std::size_t>(item.cube >> shift) & ((std::size_t{1} << digit) - 1);
    };
    std::array<std::size_t, (std::size_t{1} << digit) + 1> begin{};
    for (const VoxelRow& item : items) ++begin[bucket(item) + 1];
    for (std::size_t b = 1; b < begin.size(); ++b) begin[b] += begin[b - 1];
    for (const VoxelRow& item : items) other[begin[bucket(item)]++] = item;
    items.swap(other);
  }
}

std::vector<VoxelRow> rows_by_voxel(const Cloud& cloud, float leaf) {
  const float inverse = 1.0f / leaf;
  const auto digits = [&](float v) {
    return static_cast<std::uint64_t>(cell(v, inverse) + (std::int64_t{1} << (kBits - 1)));
  };
  std::vector<VoxelRow> out(cloud.size());
  std::uint64_t most = 0;
  for (std::size_t i = 0; i < out.size(); ++i) {
    check_cancelled_each(i, 14);
    out[i] = {digits(cloud.z[i]) << 2 * kBits | digits(cloud.y[i]) << kBits | digits(cloud.x[i]),
              static_cast<std::uint32_t>(i)};
    most = std::max(most, out[i].cube);
  }
  sort_by_voxel(out, most);
  return out;
}

std::vector<std::uint32_t> one_row_per_voxel(const Cloud& cloud, float leaf) {
  std::vector<std::uint32_t> out;
  std::uint64_t cube = 0;
  double least = 0;
  const std::vector<VoxelRow> items = rows_by_voxel(cloud, leaf);
  for (std::size_t i = 0; i < items.size(); ++i) {
    check_cancelled_each(i, 14);
    const VoxelRow& item = items[i];
    const double squared = to_centre(cloud, item.row, leaf);
    if (out.empty() || item.cube != cube) {
      out.push_back(item.row);
    } else if (squared < least) {
      out.back() = item.row;
    } else {
      continue;
    }
    cube = item.cube;
    least = squared;
  }
  std::sort(out.begin(), out.end());
  return out;
}

Cloud mean_normals(const Cloud& cloud, const Cloud& normals, float leaf) {
  const std::vector<VoxelRow> items = rows_by_voxel(cloud, leaf);
  Cloud out;
  for (std::size_t i = 0; i < items.size();) {
    check_cancelled_each(out.x.size(), 10);
    double sum[3] = {}, count = 0;
    const std::uint64_t cube = items[i].cube;
    for (; i < items.size() && items[i].cube == cube; ++i) {
      const std::size_t row = items[i].row;
      const double n[3] = {normals.x[row], normals.y[row], normals.z[row]};
      if (n[0] != n[0]) continue;
      for (int a = 0; a < 3; ++a) sum[a] += n[a];
      ++count;
    }
    const double length = std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
    const bool known = length > kCancelled * count;
    out.x.push_back(known ? static_cast<float>(sum[0] / length) : kNone);
    out.y.push_back(known ? static_cast<float>(sum[1] / length) : kNone);
    out.z.push_back(known ? static_cast<float>(sum[2] / length) : kNone);
  }
  return out;
}

}  // namespace emtr
