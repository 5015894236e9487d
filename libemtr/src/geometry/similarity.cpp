#include "geometry/similarity.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "geometry/small_motion.h"

namespace emtr {

std::optional<Similarity> similarity_from_matrix(const double transformation[16]) {
  if (is_rigid(transformation)) return Similarity{1, from_matrix(transformation)};
  Rigid pose = from_matrix(transformation);
  const double scale = std::cbrt(pose.R.determinant());
  if (!(scale > 0) || !std::isfinite(scale)) return std::nullopt;
  pose.R /= scale;
  double rigid[16];
  to_matrix(pose, rigid);
  std::copy_n(transformation + 12, 4, rigid + 12);
  if (!is_rigid(rigid)) return std::nullopt;
  return Similarity{scale, pose};
}

void to_matrix(const Similarity& similarity, double transformation[16]) {
  to_matrix(Rigid{similarity.scale * similarity.pose.R, similarity.pose.t}, transformation);
}

Similarity moved(const Similarity& similarity, const double x[7]) {
  return {similarity.scale * std::exp(x[6]), moved(similarity.pose, x)};
}

}  // namespace emtr
