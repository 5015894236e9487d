#include "candidates/plane_aligned_poses.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "candidates/dominant_planes.h"
#include "candidates/translation_votes.h"
#include "candidates/upright_points.h"
#include "features/nearest_normals.h"
#include "geometry/pose_distance.h"
#include "util/constants.h"
#include "voxels/voxel_grid.h"

namespace emtr {
namespace {

constexpr std::size_t kPlanes = 3;  // of each cloud
constexpr std::size_t kMostOfOnePair = 12;
constexpr float kEvenLeaf = 0.02F;  // radii; clouds are denser near their sensor
constexpr int kNeighbors = 16;      // that make a normal

/// Returns the pose that rotates about the aligned normals and then moves along the planes.
Rigid compose(const Upright& source, const Upright& target, int step, double x, double y) {
  const double angle = step * kYawStep;
  Rigid along;
  along.R << std::cos(angle), -std::sin(angle), 0, std::sin(angle), std::cos(angle), 0, 0, 0, 1;
  along.t = {x, y, 0};
  return target.to_plane.inverse() * along * source.to_plane;
}

struct SupportedPose {
  Rigid pose;
  double support;  ///< votes for each point that stands upright
};

const Rigid& pose_of(const SupportedPose& supported) { return supported.pose; }

std::vector<SupportedPose> best(std::vector<SupportedPose> poses, std::size_t maximum_count) {
  std::stable_sort(poses.begin(), poses.end(),
                   [](const auto& a, const auto& b) { return a.support > b.support; });
  return suppress_non_maxima(poses, kDuplicatePose, maximum_count);
}

/// Returns the poses of most votes that lay one plane on the other.
std::vector<SupportedPose> align(const Upright& source, const Upright& target,
                                 const Kernels& kernels, ThreadTeam& team) {
  const YawPairs pairs(source.points, target.points);
  std::vector<std::vector<TranslationPeak>> peaks(kYaws);
  team.parallel(kYaws, [&](std::size_t yaw, std::size_t) {
    peaks[yaw] =
        vote_for_translations(source.points, target.points, pairs, static_cast<int>(yaw), kernels);
  });
  const double points = std::sqrt(static_cast<double>(source.points.size()) *
                                  static_cast<double>(target.points.size()));
  std::vector<SupportedPose> poses;
  for (const auto& some : peaks)
    for (const TranslationPeak& peak : some)
      poses.push_back({compose(source, target, peak.yaw, peak.x, peak.y), peak.votes / points});
  return best(std::move(poses), kMostOfOnePair);
}

/// Returns the cloud with as many points everywhere: scans are denser near their sensor, and rings
/// of a spinning one have no normals of their own at a finer scale.
Surface make_even(const Cloud& cloud) {
  const Cloud even = voxel_grid(cloud, kEvenLeaf);
  return {even, nearest_normals(even, kNeighbors), kEvenLeaf};
}

}  // namespace

std::vector<Rigid> plane_aligned_poses(const SurfacePair& surfaces, std::size_t maximum_count,
                                       const Kernels& kernels, ThreadTeam& team) {
  if (maximum_count == 0) return {};
  Surface source, target;
  team.parallel(2, [&](std::size_t i, std::size_t) {
    (i == 0 ? source : target) =
        make_even(i == 0 ? surfaces.source().points : surfaces.target().points);
  });
  std::vector<Upright> sources;
  for (const DominantPlane& plane : dominant_planes(source, kPlanes))
    for (const double side : {1., -1.})  // which one is up, few points can decide
      sources.push_back(
          upright_points(source, {side * plane.normal, side * plane.offset, plane.share}));
  std::vector<SupportedPose> all;
  for (const DominantPlane& plane : dominant_planes(target, kPlanes)) {
    const Upright fixed = upright_points(target, plane);
    for (const Upright& moving : sources) {
      const std::vector<SupportedPose> poses = align(moving, fixed, kernels, team);
      all.insert(all.end(), poses.begin(), poses.end());
    }
  }
  std::vector<Rigid> out;
  for (const SupportedPose& supported : best(std::move(all), maximum_count))
    out.push_back(supported.pose);
  return out;
}

}  // namespace emtr
