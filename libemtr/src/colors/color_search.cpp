#include "colors/color_search.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "geometry/pose_distance.h"
#include "util/constants.h"
#include "voxels/voxel_grid.h"
#include "voxels/voxel_order.h"

namespace emtr {
namespace {

constexpr std::size_t kCoarseQueries = 200, kMiddleQueries = 1500, kFineQueries = 4000;
constexpr double kFarthest = 1.2;          // radii, of the source's centroid
constexpr double kTranslationStep = 0.06;  // radii
constexpr double kRotationStep = 5 * kDegree;
constexpr std::size_t kMostFree = 3;
constexpr double kMostPlaces = 6e5;  // of the lattice
constexpr std::size_t kChunk = 256;  // poses that are one piece of work
constexpr std::size_t kPeaks = 48, kRanked = 3000;
constexpr PoseDistance kPeakDistance = {7 * kDegree, 0.08};
constexpr double kLeastStep = 0.004;  // radii, of the way uphill

ColorCorrelation downsampled(const FineSurfaces& fine, const Channels& channels, double leaf,
                             std::size_t queries, const Kernels& kernels) {
  if (leaf <= fine.leaf())
    return {fine.source->points, fine.target->points, channels, fine.leaf(), queries, kernels};
  const auto side = static_cast<float>(leaf);
  Channels means = channels;
  means.source = mean_colors(fine.source->points, channels.source, side);
  means.target = mean_colors(fine.target->points, channels.target, side);
  return {voxel_grid(fine.source->points, side),
          voxel_grid(fine.target->points, side),
          std::move(means),
          leaf,
          queries,
          kernels};
}

/// The places of a regular lattice, each a vector of angles and then of translations.
class Lattice {
 public:
  explicit Lattice(const FreeMotions& motions)
      : motions_(motions),
        rotations_(motions.rotations()),
        half_angle_(static_cast<int>(std::round(kPi / kRotationStep))),
        half_length_(static_cast<int>(std::ceil(kFarthest / kTranslationStep))) {
    size_ = 1;
    for (std::size_t k = 0; k < motions.size(); ++k) size_ *= count(k);
  }

  std::size_t size() const { return size_; }

  /// Returns the place of this number, empty where it is a duplicate or too far away.
  Eigen::VectorXd at(std::size_t number) const {
    Eigen::VectorXd x(static_cast<Eigen::Index>(motions_.size()));
    double angle = 0, length = 0;
    for (std::size_t k = 0; k < motions_.size(); ++k) {
      const auto step = static_cast<int>(number % count(k));
      number /= count(k);
      double& value = x[static_cast<Eigen::Index>(k)];
      if (k < rotations_) {
        value = (step + 1 - half_angle_) * kRotationStep;
        angle += value * value;
      } else {
        value = (step - half_length_) * kTranslationStep;
        length += value * value;
      }
    }
    const double most = kPi + 1e-9;
    if (angle > most * most || length > kFarthest * kFarthest) return {};
    return x;
  }

 private:
  std::size_t count(std::size_t k) const {
    return static_cast<std::size_t>(k < rotations_ ? 2 * half_angle_ : 2 * half_length_ + 1);
  }

  const FreeMotions& motions_;
  const std::size_t rotations_;
  const int half_angle_, half_length_;
  std::size_t size_ = 1;
};

struct Place {
  Eigen::VectorXd x;
  Rigid pose;
  double evidence = 0;
};

const Rigid& pose_of(const Place& place) { return place.pose; }

bool is_better(const Place& a, const Place& b) { return a.evidence > b.evidence; }

bool is_near_prior(const Rigid& pose, const Prior* prior) {
  return !prior || is_same_pose(prior->project(pose), pose, kPeakDistance);
}

/// Moves a place uphill along its coordinates, by steps that shrink.
void climb(const ColorCorrelation& colors, const FreeMotions& motions, Place& place,
           ColorCorrelation::Scratch& scratch) {
  place.evidence = colors.evaluate(place.pose, scratch).evidence;
  for (double step = kTranslationStep / 2; step > kLeastStep;) {
    Place best = place;
    for (Eigen::Index k = 0; k < place.x.size(); ++k)
      for (const double sign : {-1.0, 1.0}) {
        Place next = place;
        next.x[k] += sign * step;
        next.pose = motions.at(next.x);
        next.evidence = colors.evaluate(next.pose, scratch).evidence;
        if (is_better(next, best)) best = next;
      }
    if (is_better(best, place))
      place = best;
    else
      step /= 2;
  }
}

/// Judges all places of the lattice by coarse colors, and returns the best ones.
std::vector<Place> scan(const ColorCorrelation& colors, const FreeMotions& motions,
                        const Lattice& lattice, const Prior* prior, ThreadTeam& team) {
  std::vector<float> evidence(lattice.size(), -1e30f);
  std::vector<ColorCorrelation::Scratch> scratch(team.size());
  team.parallel((lattice.size() + kChunk - 1) / kChunk, [&](std::size_t chunk, std::size_t thread) {
    const std::size_t end = std::min(lattice.size(), (chunk + 1) * kChunk);
    for (std::size_t i = chunk * kChunk; i < end; ++i) {
      const Eigen::VectorXd x = lattice.at(i);
      if (x.size() == 0) continue;
      const Rigid pose = motions.at(x);
      if (is_near_prior(pose, prior))
        evidence[i] = static_cast<float>(colors.evaluate(pose, scratch[thread]).evidence);
    }
  });
  std::vector<std::size_t> order(lattice.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const std::size_t ranked = std::min(order.size(), kRanked);
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(ranked), order.end(),
                    [&](std::size_t a, std::size_t b) {
                      return evidence[a] > evidence[b] || (evidence[a] == evidence[b] && a < b);
                    });
  std::vector<Place> places;
  for (std::size_t k = 0; k < ranked; ++k) {
    if (!(evidence[order[k]] > 0)) break;
    const Eigen::VectorXd x = lattice.at(order[k]);
    places.push_back({x, motions.at(x), static_cast<double>(evidence[order[k]])});
  }
  return suppress_non_maxima(places, kPeakDistance, kPeaks);
}

}  // namespace

ColorLevels::ColorLevels(const FineSurfaces& fine, const Channels& channels, const Kernels& kernels)
    : coarse_(downsampled(fine, channels, kCoarseLeaf, kCoarseQueries, kernels)),
      middle_(downsampled(fine, channels, kMiddleLeaf, kMiddleQueries, kernels)),
      fine_(downsampled(fine, channels, fine.leaf(), kFineQueries, kernels)) {}

FoundByColor search_by_color(const ColorLevels& levels, const FreeMotions& motions,
                             const Prior* prior, std::size_t maximum_count, ThreadTeam& team) {
  FoundByColor out;
  if (motions.size() == 0 || motions.size() > kMostFree) return out;
  const Lattice lattice(motions);
  if (static_cast<double>(lattice.size()) > kMostPlaces) return out;
  std::vector<Place> places = scan(levels.coarse(), motions, lattice, prior, team);
  std::vector<ColorCorrelation::Scratch> scratch(team.size());
  team.parallel(places.size(), [&](std::size_t i, std::size_t thread) {
    climb(levels.middle(), motions, places[i], scratch[thread]);
  });
  std::stable_sort(places.begin(), places.end(), is_better);
  for (const Place& place : suppress_non_maxima(places, kDuplicatePose, maximum_count))
    out.poses.push_back(place.pose);
  out.looked_at = lattice.size();
  return out;
}

}  // namespace emtr
