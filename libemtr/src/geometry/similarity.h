#pragma once

#include <optional>

#include "geometry/rigid.h"
#include "geometry/transform.h"

namespace emtr {

/// A similarity, source into target: q = scale R p + t. With scale 1 all its values have the bits
/// of its rigid pose's.
struct Similarity {
  double scale = 1;  ///< of the source's lengths, above 0
  Rigid pose;        ///< R and t

  Eigen::Vector3d operator*(const Eigen::Vector3d& p) const {
    return scale * pose.rotate(p) + pose.t;
  }

  /// Returns R p, which keeps the length of a direction.
  Eigen::Vector3d rotate(const Eigen::Vector3d& p) const { return pose.rotate(p); }

  Similarity inverse() const {
    Similarity out{1 / scale, pose.inverse()};
    out.pose.t /= scale;
    return out;
  }
};

/// Reads a row-major 4x4 matrix; empty when it is no similarity. A rigid one, to the precision in
/// which people write matrices down, has scale 1.
std::optional<Similarity> similarity_from_matrix(const double transformation[16]);

/// Writes a similarity as a row-major 4x4 matrix, whose upper 3x3 is scale R.
void to_matrix(const Similarity& similarity, double transformation[16]);

/// Returns the similarity after a small change x: first a change of the logarithm of the scale by
/// x[6] about where the source's origin ends, then the small motion of moved() by x[0..5].
Similarity moved(const Similarity& similarity, const double x[7]);

/// Writes scale R p + t of each point, in float; the three arrays have room for as many points.
inline void transform(const Kernels& kernels, const PointsView& points,
                      const Similarity& similarity, float* x, float* y, float* z) {
  const Rigid& pose = similarity.pose;
  transform(kernels, points, Rigid{similarity.scale * pose.R, pose.t}, x, y, z);
}

}  // namespace emtr
