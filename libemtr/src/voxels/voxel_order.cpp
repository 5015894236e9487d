#include "voxels/voxel_order.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "util/cancellation.h"
#include "util/constants.h"
#include "voxels/voxel_index.h"

namespace emtr {
namespace {

constexpr double kMinimumLength = 0.1;  // a shorter mean of unit vectors has no direction
constexpr int kBits = 21;               // of a voxel's number, for each axis

double squared_distance_to_center(const Cloud& cloud, std::size_t i, float leaf) {
  const float inverse = 1.0f / leaf;
  const auto off = [&](float v) {
    return double{v} - (static_cast<double>(voxel_index(v, inverse)) + 0.5) * double{leaf};
  };
  const double x = off(cloud.x[i]), y = off(cloud.y[i]), z = off(cloud.z[i]);
  return x * x + y * y + z * z;
}

/// Calls visit(sum, count) for each voxel that holds points, with the sum of their values and how
/// many have one, not NaN.
template <class Visit>
void for_each_voxel(const Cloud& cloud, const Cloud& values, float leaf, const Visit& visit) {
  const std::vector<VoxelRow> items = rows_by_voxel(cloud, leaf);
  std::size_t voxels = 0;
  for (std::size_t i = 0; i < items.size();) {
    check_cancelled_each(voxels++, 10);
    double sum[3] = {}, count = 0;
    const std::uint64_t voxel = items[i].voxel;
    for (; i < items.size() && items[i].voxel == voxel; ++i) {
      const std::size_t row = items[i].row;
      const double v[3] = {values.x[row], values.y[row], values.z[row]};
      if (v[0] != v[0]) continue;
      for (int a = 0; a < 3; ++a) sum[a] += v[a];
      ++count;
    }
    visit(sum, count);
  }
}

/// Appends sum / divisor, NaN where both are 0.
void append_quotient(const double sum[3], double divisor, Cloud& out) {
  out.append(static_cast<float>(sum[0] / divisor), static_cast<float>(sum[1] / divisor),
             static_cast<float>(sum[2] / divisor));
}

}  // namespace

/// Sorts by radix, the least significant digit first.
void sort_by_voxel(std::vector<VoxelRow>& items, std::uint64_t maximum) {
  constexpr int digit = 11;
  std::vector<VoxelRow> sorted(items.size());
  for (int shift = 0; shift < 64 && (maximum >> shift); shift += digit) {
    check_cancelled();  // a pass over a million items takes some milliseconds
    const auto bucket = [shift](const VoxelRow& item) {
      return static_cast<std::size_t>(item.voxel >> shift) & ((std::size_t{1} << digit) - 1);
    };
    std::array<std::size_t, (std::size_t{1} << digit) + 1> begin{};
    for (const VoxelRow& item : items) ++begin[bucket(item) + 1];
    for (std::size_t b = 1; b < begin.size(); ++b) begin[b] += begin[b - 1];
    for (const VoxelRow& item : items) sorted[begin[bucket(item)]++] = item;
    items.swap(sorted);
  }
}

std::vector<VoxelRow> rows_by_voxel(const Cloud& cloud, float leaf) {
  const float inverse = 1.0f / leaf;
  const auto along = [&](float v) {
    return static_cast<std::uint64_t>(voxel_index(v, inverse) + (std::int64_t{1} << (kBits - 1)));
  };
  std::vector<VoxelRow> out(cloud.size());
  std::uint64_t maximum = 0;
  for (std::size_t i = 0; i < out.size(); ++i) {
    check_cancelled_each(i, 14);
    out[i] = {along(cloud.z[i]) << 2 * kBits | along(cloud.y[i]) << kBits | along(cloud.x[i]),
              static_cast<std::uint32_t>(i)};
    maximum = std::max(maximum, out[i].voxel);
  }
  sort_by_voxel(out, maximum);
  return out;
}

std::vector<std::uint32_t> one_row_per_voxel(const Cloud& cloud, float leaf) {
  std::vector<std::uint32_t> out;
  std::uint64_t voxel = 0;
  double smallest = 0;
  const std::vector<VoxelRow> items = rows_by_voxel(cloud, leaf);
  for (std::size_t i = 0; i < items.size(); ++i) {
    check_cancelled_each(i, 14);
    const VoxelRow& item = items[i];
    const double squared = squared_distance_to_center(cloud, item.row, leaf);
    if (out.empty() || item.voxel != voxel) {
      out.push_back(item.row);
    } else if (squared < smallest) {
      out.back() = item.row;
    } else {
      continue;
    }
    voxel = item.voxel;
    smallest = squared;
  }
  std::sort(out.begin(), out.end());
  return out;
}

Cloud mean_normals(const Cloud& cloud, const Cloud& normals, float leaf) {
  Cloud out;
  for_each_voxel(cloud, normals, leaf, [&](const double sum[3], double count) {
    const double length = std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
    if (length > kMinimumLength * count)
      append_quotient(sum, length, out);
    else
      out.append(kNone, kNone, kNone);
  });
  return out;
}

Cloud mean_colors(const Cloud& cloud, const Cloud& colors, float leaf) {
  Cloud out;
  for_each_voxel(cloud, colors, leaf,
                 [&](const double sum[3], double count) { append_quotient(sum, count, out); });
  return out;
}

}  // namespace emtr
