#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "geometry/cloud.h"
#include "util/memo.h"

namespace emtr {

/// A cloud with the directions of its surface, in the normalized frame, in any order.
struct Surface {
  Cloud points;
  Cloud normals;         ///< one a point; unit length, either sign, NaN where there is none
  double leaf = 0;       ///< spacing of the points, above 0
  bool weighted = true;  ///< by its distinctiveness() in a score
};

/// Flips each normal that points away from the viewpoint.
void orient_normals(const Cloud& points, const std::array<float, 3>& viewpoint, Cloud& normals);

/// Returns every `step`-th point with its normal; keeps the leaf.
Surface every_nth(const Surface& surface, std::size_t step);

/// A surface that no longer changes, owned jointly by all that score or refine poses on it, and
/// not copied with this handle. Holds its points a second time, interleaved with their normals:
/// a nearest neighbor is then read from one cache line, whichever point it is.
class SharedSurface {
 public:
  SharedSurface(Surface surface);

  const Surface& operator*() const { return owned_->surface; }
  const Surface* operator->() const { return &owned_->surface; }

  /// Holds as many entries as points that come with a normal; users refuse a surface that lacks
  /// some.
  const std::vector<SurfacePoint>& interleaved() const { return owned_->interleaved; }

  /// What was made of the surface, such as its neighbor structures.
  Memo& memo() const { return owned_->memo; }

 private:
  struct Owned {
    Surface surface;
    std::vector<SurfacePoint> interleaved;
    mutable Memo memo;
  };
  std::shared_ptr<const Owned> owned_;
};

}  // namespace emtr
