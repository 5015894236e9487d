#pragma once

#include <emtr/emtr.h>

#include <cstddef>

#include "../cloud.h"
#include "../rigid.h"

namespace emtr {

/// The normalised frame: each cloud is centred on its own centroid, and both are divided by one
/// scale, the larger of the two radii, so that all points lie in the unit ball.
struct Frame {
  double scale = 1;              ///< the user's unit
  double center_source[3] = {};  ///< the user's unit
  double center_target[3] = {};

  /// From a pose in the normalised frame to one in the user's unit, and back.
  Rigid to_user(const Rigid& pose) const;
  Rigid to_normalised(const Rigid& pose) const;
};

/// Both clouds in that frame. Points with a NaN or an infinity are gone, and counted.
struct NormalisedPair {
  Frame frame;
  Cloud source, target;
  std::size_t dropped_source = 0, dropped_target = 0;
};

/// In double throughout, and float only at the end, so that large offsets cost no digits.
/// Throws Error when a cloud has fewer than 10 finite points, or all on one point or line.
NormalisedPair normalise(const emtr_cloud& source, const emtr_cloud& target);

}  // namespace emtr
