#include "candidates/places.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "candidates/fallback_search.h"
#include "correspondences/matching.h"
#include "features/fpfh.h"
#include "neighbors/resolution.h"
#include "util/thread_team.h"
#include "voxels/voxel_counter.h"
#include "voxels/voxel_grid.h"

namespace emtr {
namespace {

constexpr double kFinestLeaf = 2e-3;        // of the large cloud's radius: PCL's indices end there
constexpr std::size_t kFewestPoints = 100;  // of the small cloud: fewer show no shape
constexpr int kNearest = 3;                 // of each other, to be a match

/// Returns the finest leaf at which each cloud is a surface and neither has too many points. The
/// large one may have more where the small one would have few, as far as time and memory go.
float leaf_for(const Cloud& small, const Cloud& large) {
  constexpr double kSpacings = 1.5, kSlightly = 1.02;
  constexpr double kSmall = 2000, kSmallEnough = 600, kLarge = 4e5, kLargest = 1.2e6;
  constexpr std::size_t kSample = 2000;  // for a mean to about one percent
  const double spacing = std::max(mean_spacing(small, kSample), mean_spacing(large, kSample));
  double leaf = std::max(kFinestLeaf, kSpacings * spacing);
  VoxelCounter of_small(small), of_large(large);
  for (;;) {
    check_cancelled();
    const auto points = static_cast<double>(of_small(static_cast<float>(leaf))),
               others = static_cast<double>(of_large(static_cast<float>(leaf)));
    const double most = std::clamp(kLarge * kSmallEnough / points, kLarge, kLargest);
    const double excess = std::max(points / kSmall, others / most);
    if (excess <= 1) return static_cast<float>(leaf);
    leaf *= kSlightly * std::sqrt(excess);  // a surface has as many as the squared leaf is smaller
  }
}

/// Returns the features of the cloud, and then those of it with all normals reversed.
Features both_sides(const Features& features) {
  Features out = features;
  const Features other = mirrored(features);
  out.normals.insert(out.normals.end(), other.normals.begin(), other.normals.end());
  out.descriptors.insert(out.descriptors.end(), other.descriptors.begin(), other.descriptors.end());
  return out;
}

}  // namespace

std::vector<Rigid> find_places(const Cloud& small, const Cloud& large, const Settings& settings,
                               const Kernels& kernels) {
  const int threads = thread_count(settings);
  const float leaf = leaf_for(small, large);
  const Cloud part = voxel_grid(small, leaf), whole = voxel_grid(large, leaf);
  if (part.size() < kFewestPoints) return {};

  FeatureDefinition definition = feature_definition(settings, leaf);
  definition.backend = FeatureBackend::Simd;
  const Features of_part = describe(part, definition, kernels, threads),
                 of_whole = describe(whole, definition, kernels, threads);
  // A normal's side is a guess, and both guesses are right somewhere on an object: matches of
  // either support one pose.
  auto matches = match_distinctive(both_sides(of_part), of_whole, kNearest,
                                   static_cast<std::size_t>(settings.fallback_correspondences),
                                   kernels, threads);
  const auto count = static_cast<std::int32_t>(part.size());
  for (Correspondence& match : matches) match.source %= count;

  return poses_of_matches(part, whole, matches, static_cast<double>(leaf), settings, kernels,
                          threads);
}

}  // namespace emtr
