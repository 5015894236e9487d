#pragma once

#include <cstddef>
#include <memory>

#include "geometry/cloud.h"

namespace emtr {

/// Finds the point of a cloud nearest to any place, by PCL's kd-tree. The cloud has at least one.
class NearestPoint {
 public:
  explicit NearestPoint(const Cloud& cloud);
  ~NearestPoint();

  /// Returns the row of the nearest point. Rounding of floats, a share of 1e-6 of the distance or
  /// of the cloud, may choose another of nearly the same distance. Threads may call it
  /// concurrently.
  std::size_t operator()(const float place[3]) const;

 private:
  struct Tree;
  std::unique_ptr<const Tree> tree_;
};

}  // namespace emtr
