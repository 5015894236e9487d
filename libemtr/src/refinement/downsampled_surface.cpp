#include "refinement/downsampled_surface.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "voxels/voxel_order.h"
#include "util/cancellation.h"

namespace emtr {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

/// Count, sum of the coordinates, and sum of their products xx, xy, xz, yy, yz, zz.
using Moments = std::array<double, 10>;

Moments moments_of(double x, double y, double z) {
  return {1, x, y, z, x * x, x * y, x * z, y * y, y * z, z * z};
}

void add(Moments& sum, const Moments& m) {
  for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += m[k];
}

void subtract(Moments& sum, const Moments& m) {
  for (std::size_t k = 0; k < sum.size(); ++k) sum[k] -= m[k];
}

/// Where the cubes lie: key = (z * size_y + y) * size_x + x, with a margin of empty ones, so that
/// no row of neighbors runs over into the next.
struct Lattice {
  float inverse;
  std::int64_t low[3], size[3];

  Lattice(const Cloud& cloud, double leaf, int margin) : inverse(1 / static_cast<float>(leaf)) {
    const std::vector<float>* axes[3] = {&cloud.x, &cloud.y, &cloud.z};
    for (int a = 0; a < 3; ++a) {
      const auto [least, most] = std::minmax_element(axes[a]->begin(), axes[a]->end());
      low[a] = cell(*least) - margin;
      size[a] = cell(*most) - low[a] + margin + 1;
    }
  }

  /// pcl::VoxelGrid's binning.
  std::int64_t cell(float v) const { return static_cast<std::int64_t>(std::floor(v * inverse)); }

  std::uint64_t key(const Cloud& cloud, std::size_t i) const {
    return static_cast<std::uint64_t>(
        ((cell(cloud.z[i]) - low[2]) * size[1] + cell(cloud.y[i]) - low[1]) * size[0] +
        cell(cloud.x[i]) - low[0]);
  }
};

/// The occupied cubes in order, and the running sums of the moments before each of them.
struct Cubes {
  std::vector<std::uint64_t> keys;
  std::vector<Moments> before;  // one more than keys
};

Cubes fill(const Cloud& cloud, const Lattice& lattice) {
  std::vector<VoxelRow> items(cloud.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    check_cancelled_each(i, 14);
    items[i] = {lattice.key(cloud, i), static_cast<std::uint32_t>(i)};
  }
  sort_by_voxel(items,
               static_cast<std::uint64_t>(lattice.size[0] * lattice.size[1] * lattice.size[2]));
  Cubes voxel_order;
  Moments sum{};
  for (const VoxelRow& item : items) {
    check_cancelled_each(static_cast<std::size_t>(&item - items.data()), 14);
    if (voxel_order.keys.empty() || item.cube != voxel_order.keys.back()) {
      voxel_order.keys.push_back(item.cube);
      voxel_order.before.push_back(sum);
    }
    add(sum, moments_of(cloud.x[item.row], cloud.y[item.row], cloud.z[item.row]));
  }
  voxel_order.before.push_back(sum);
  return voxel_order;
}

std::array<float, 3> centroid(const Cubes& voxel_order, std::size_t i) {
  Moments own = voxel_order.before[i + 1];
  subtract(own, voxel_order.before[i]);
  return {static_cast<float>(own[1] / own[0]), static_cast<float>(own[2] / own[0]),
          static_cast<float>(own[3] / own[0])};
}

/// A row of cubes beside the one at hand: keys from +first to +last, found by two cursors that
/// only move forward as the one at hand does.
struct Row {
  std::int64_t first, last;
  std::size_t begin = 0, end = 0;

  void follow(const std::vector<std::uint64_t>& keys, std::uint64_t key) {
    const auto at = static_cast<std::int64_t>(key);
    while (begin < keys.size() && static_cast<std::int64_t>(keys[begin]) < at + first) ++begin;
    end = std::max(begin, end);
    while (end < keys.size() && static_cast<std::int64_t>(keys[end]) <= at + last) ++end;
  }
};

/// The cubes whose centre is within `reach` leaves of the centre of the one at hand.
std::vector<Row> ball(const Lattice& lattice, double reach) {
  std::vector<Row> rows;
  const int most = static_cast<int>(reach);
  for (int z = -most; z <= most; ++z)
    for (int y = -most; y <= most; ++y) {
      const double left = reach * reach - y * y - z * z;
      if (left < 0) continue;
      const auto half = static_cast<std::int64_t>(std::sqrt(left));
      const std::int64_t centre = (z * lattice.size[1] + y) * lattice.size[0];
      rows.push_back({centre - half, centre + half});
    }
  return rows;
}

Eigen::Vector3f normal_of(const Moments& m) {
  Eigen::Vector3f none = Eigen::Vector3f::Constant(kNone);
  if (m[0] < kLeastForNormal) return none;
  const Eigen::Vector3d mean = Eigen::Vector3d(m[1], m[2], m[3]) / m[0];
  Eigen::Matrix3d scatter;
  scatter << m[4], m[5], m[6], m[5], m[7], m[8], m[6], m[8], m[9];
  scatter = scatter / m[0] - mean * mean.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(scatter);
  const Eigen::Vector3d spread = solver.eigenvalues();
  if (!(spread[1] > 1e-6 * spread[2])) return none;  // one point or one line: no surface
  return solver.eigenvectors().col(0).cast<float>();
}

}  // namespace

Surface downsample_surface(const Cloud& cloud, double leaf, double reach) {
  Surface out;
  out.leaf = leaf;
  if (cloud.size() == 0) return out;
  const Lattice lattice(cloud, leaf, static_cast<int>(reach));
  const Cubes voxel_order = fill(cloud, lattice);
  std::vector<Row> rows = ball(lattice, reach);
  const std::size_t n = voxel_order.keys.size();
  out.points.resize(n);
  out.normals.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    check_cancelled_each(i, 10);
    out.points.set(i, centroid(voxel_order, i).data());
    Moments about{};
    for (Row& row : rows) {
      row.follow(voxel_order.keys, voxel_order.keys[i]);
      if (row.begin == row.end) continue;
      add(about, voxel_order.before[row.end]);
      subtract(about, voxel_order.before[row.begin]);
    }
    const Eigen::Vector3f normal = normal_of(about);
    out.normals.x[i] = normal.x();
    out.normals.y[i] = normal.y();
    out.normals.z[i] = normal.z();
  }
  return out;
}

Surface downsample_surface(const Cloud& cloud, const Cloud& normals, double leaf) {
  Surface out;
  out.leaf = leaf;
  if (cloud.size() == 0) return out;
  const Cubes voxel_order = fill(cloud, Lattice(cloud, leaf, 0));
  out.points.resize(voxel_order.keys.size());
  for (std::size_t i = 0; i < voxel_order.keys.size(); ++i) out.points.set(i, centroid(voxel_order, i).data());
  out.normals = mean_normals(cloud, normals, static_cast<float>(leaf));
  return out;
}

}  // namespace emtr
