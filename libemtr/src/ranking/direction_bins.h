#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "geometry/rigid.h"

namespace emtr {

/// Bins of directions on the six faces of a cube about a viewpoint, of nearly one angular size
/// all over. The cube faces a given place, so that most scans are seen through one face.
class DirectionBins {
 public:
  struct Bin {
    std::int32_t face, column, row;
  };

  /// `size`: the bins' angular size to aim for, in radians.
  DirectionBins(const double viewpoint[3], const double facing[3], double size);

  /// Maps into the cube's own frame: the viewpoint at the origin, the faced place along z.
  const Rigid& to_view() const { return to_view_; }
  std::int32_t side() const { return side_; }  ///< bins along an edge of a face

  /// Returns the bin of a direction in the cube's frame, of any length.
  Bin operator()(float x, float y, float z) const {
    const float ax = std::abs(x), ay = std::abs(y), az = std::abs(z);
    if (az >= ax && az >= ay) return on_face(z > 0 ? 0 : 1, x, y, az);
    if (ax >= ay) return on_face(x > 0 ? 2 : 3, y, z, ax);
    return on_face(y > 0 ? 4 : 5, z, x, ay);
  }

  float half_side() const { return half_side_; }  ///< as the kernels ask for it

 private:
  Bin on_face(std::int32_t face, float a, float b, float depth) const {
    const float inverse = 1.0f / std::max(depth, 1e-20f);
    return {face, along(a * inverse), along(b * inverse)};
  }

  /// Maps the tangent of an angle within 45 degrees to a bin along the face, by a cubic near enough
  /// to the angle itself: where it is not, bins are a little larger or smaller.
  std::int32_t along(float tangent) const {
    const float place = tangent * (1.2f - 0.2f * tangent * tangent);
    const auto at = static_cast<std::int32_t>((place + 1) * half_side_);
    return at < side_ ? at : side_ - 1;
  }

  Rigid to_view_;
  std::int32_t side_;
  float half_side_;
};

}  // namespace emtr
