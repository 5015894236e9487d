#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/surface.h"

namespace emtr {

/// The points of a surface that look for their match on another one: spread evenly over those with
/// a normal, and ordered so that the first few are spread evenly too.
class QueryPoints {
 public:
  /// At most `count` of them; `first_count`: how many are to be first(), about.
  QueryPoints(const SharedSurface& surface, std::size_t count, std::size_t first_count);

  std::size_t size() const { return rows_.size(); }
  std::size_t first() const { return first_; }  ///< how many make a thinned part of all

  /// Returns the positions of the queries begin to end.
  PointsView view(std::size_t begin, std::size_t end) const {
    const PointsView all = positions_.view();
    return {all.x + begin, all.y + begin, all.z + begin, end - begin};
  }
  const std::int32_t* rows() const { return rows_.data(); }  ///< of the queries in surface()
  /// Returns all points of the surface, not the queries alone.
  const SurfacePoint* surface() const { return surface_.interleaved().data(); }

 private:
  SharedSurface surface_;
  std::vector<std::int32_t> rows_;
  Cloud positions_;
  std::size_t first_ = 0;
};

}  // namespace emtr
