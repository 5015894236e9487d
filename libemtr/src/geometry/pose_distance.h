#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "geometry/rigid.h"

namespace emtr {

/// How far apart two poses are in the normalized frame, where a pose's t moves the source's
/// centroid: the angle between the rotations and the distance between the translations.
struct PoseDistance {
  double angle;   ///< radians
  double offset;  ///< radii
};

/// Poses further apart than this are different answers, not one answer found twice.
constexpr PoseDistance kDistinctPose = {10 * 3.14159265358979323846 / 180, 0.15};
/// Poses nearer than this end in the same place when they are polished.
constexpr PoseDistance kDuplicatePose = {3 * 3.14159265358979323846 / 180, 0.03};

bool within(const Rigid& a, const Rigid& b, const PoseDistance& limit);

inline const Rigid& pose_of(const Rigid& pose) { return pose; }

/// The first `most` items, in their order, that are not within the limit of one taken before.
template <class Item>
std::vector<Item> distinct(const std::vector<Item>& items, const PoseDistance& limit,
                           std::size_t most) {
  std::vector<Item> out;
  for (const Item& item : items) {
    if (out.size() == most) break;
    const auto near = [&](const Item& other) {
      return within(pose_of(item), pose_of(other), limit);
    };
    if (std::none_of(out.begin(), out.end(), near)) out.push_back(item);
  }
  return out;
}

}  // namespace emtr
