#pragma once

#include <cstddef>
#include <memory>

#include "geometry/cloud.h"

namespace emtr {

/// A cloud of at least one point, asked for the nearest to any place. PCL's kd-tree.
class NearestPoint {
 public:
  explicit NearestPoint(const Cloud& cloud);
  ~NearestPoint();

  /// The row of a point that no other is nearer than, but for the rounding of floats: a share of
  /// 1e-6 of the distance or of the cloud. Threads may ask at the same time.
  std::size_t operator()(const float place[3]) const;

 private:
  struct Tree;
  std::unique_ptr<const Tree> tree_;
};

}  // namespace emtr
