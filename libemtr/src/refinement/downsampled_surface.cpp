#include "refinement/downsampled_surface.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <vector>

#include "refinement/voxel_moments.h"
#include "util/cancellation.h"
#include "util/constants.h"
#include "voxels/voxel_order.h"

namespace emtr {
namespace {

Eigen::Vector3f normal_of(const Moments& m) {
  Eigen::Vector3f none = Eigen::Vector3f::Constant(kNone);
  if (m[0] < kMinimumForNormal) return none;
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
  const VoxelLattice lattice(cloud, leaf, static_cast<int>(reach));
  const VoxelMoments voxels(cloud, lattice);
  std::vector<VoxelRun> rows = ball(lattice, reach);
  const std::size_t n = voxels.keys.size();
  out.points.resize(n);
  out.normals.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    check_cancelled_each(i, 10);
    out.points.set(i, voxels.centroid(i).data());
    Moments around{};
    for (VoxelRun& row : rows) {
      row.follow(voxels.keys, voxels.keys[i]);
      if (row.begin == row.end) continue;
      add(around, voxels.before[row.end]);
      subtract(around, voxels.before[row.begin]);
    }
    out.normals.set(i, normal_of(around).data());
  }
  return out;
}

Surface downsample_surface(const Cloud& cloud, const Cloud& normals, double leaf) {
  Surface out;
  out.leaf = leaf;
  if (cloud.size() == 0) return out;
  const VoxelMoments voxels(cloud, VoxelLattice(cloud, leaf, 0));
  out.points.resize(voxels.keys.size());
  for (std::size_t i = 0; i < voxels.keys.size(); ++i) out.points.set(i, voxels.centroid(i).data());
  out.normals = mean_normals(cloud, normals, static_cast<float>(leaf));
  return out;
}

}  // namespace emtr
