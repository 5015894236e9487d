#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "geometry/rigid.h"
#include "util/constants.h"

namespace emtr {

/// A distance between two poses in the normalized frame, where a pose's t moves the source's
/// centroid: the angle between the rotations and the distance between the translations.
struct PoseDistance {
  double angle;        ///< radians
  double translation;  ///< radii
};

/// Poses farther apart than this are different answers, not one answer found twice.
constexpr PoseDistance kDistinctPose = {10 * kPi / 180, 0.15};
/// Poses closer than this end in the same place after local refinement.
constexpr PoseDistance kDuplicatePose = {3 * kPi / 180, 0.03};

/// Tells whether neither rotations nor translations are farther apart than the limit.
bool is_same_pose(const Rigid& a, const Rigid& b, const PoseDistance& limit);

inline const Rigid& pose_of(const Rigid& pose) { return pose; }

/// Non-maximum suppression: returns the first `maximum_count` of the items, best first, without
/// those whose pose is the same as that of a better one that was kept.
template <class Item>
std::vector<Item> suppress_non_maxima(const std::vector<Item>& ranked, const PoseDistance& limit,
                                      std::size_t maximum_count) {
  std::vector<Item> kept;
  for (const Item& item : ranked) {
    if (kept.size() == maximum_count) break;
    const auto is_same = [&](const Item& other) {
      return is_same_pose(pose_of(item), pose_of(other), limit);
    };
    if (std::none_of(kept.begin(), kept.end(), is_same)) kept.push_back(item);
  }
  return kept;
}

}  // namespace emtr
