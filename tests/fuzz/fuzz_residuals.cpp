// Fuzzes the distances between the points of two clouds, moved by any matrix.
#include <emtr/emtr.h>

#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <vector>

#include "any_cloud.h"
#include "calls.h"
#include "input.h"

namespace {

using Eigen::Vector3d;
using fuzz::AnyCloud;
using fuzz::require;

std::vector<Vector3d> points_of(const AnyCloud& cloud) {
  std::vector<Vector3d> out(cloud.view().count);
  for (std::size_t i = 0; i < out.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) out[i][static_cast<int>(k)] = cloud.coordinate(i, k);
  return out;
}

/// Compares with the nearest of all points, to the precision that the header promises.
void require_distances(const std::vector<double>& distances, const std::vector<Vector3d>& points,
                       const std::vector<Vector3d>& others) {
  Vector3d low = Vector3d::Constant(INFINITY), high = -low;
  for (const Vector3d& p : others)
    if (p.allFinite()) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  const double size = (high - low).maxCoeff();
  for (std::size_t i = 0; i < points.size(); ++i) {
    require(std::isnan(distances[i]) == !points[i].allFinite());
    if (std::isnan(distances[i])) continue;
    double least = INFINITY;
    for (const Vector3d& p : others)
      if (p.allFinite()) least = std::min(least, (points[i] - p).stableNorm());
    const double rounding = 1e-12 * (points[i].stableNorm() + low.stableNorm() + size) +
                            std::numeric_limits<double>::min();  // below it numbers lose digits
    require(distances[i] == least ||
            std::abs(distances[i] - least) <= 1e-6 * std::max(size, least) + rounding);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Input input(data, size);
  const AnyCloud source(input, 32), target(input, 32);
  Eigen::Matrix<double, 4, 4, Eigen::RowMajor> T;
  T.setIdentity();
  if (input.ConsumeBool()) {  // 90 degrees about x
    T.row(1).swap(T.row(2));
    T.row(1) *= -1;
  }
  for (int n = input.ConsumeIntegralInRange(0, 2); n > 0; --n) {
    // Mostly the translation, which keeps it rigid whatever it is.
    const int place = 4 * input.ConsumeIntegralInRange(0, 2) + 3;
    T.data()[input.ConsumeBool() ? place : input.ConsumeIntegralInRange(0, 15)] =
        fuzz::any_double(input);
  }
  std::vector<double> of_source(source.view().count), of_target(target.view().count);
  const bool both = input.ConsumeBool();
  if (!fuzz::accepted(emtr_residuals(&source.view(), &target.view(), T.data(), 1, of_source.data(),
                                     both ? of_target.data() : nullptr)))
    return 0;
  const Eigen::Matrix3d R = T.topLeftCorner<3, 3>();
  const Vector3d t = T.topRightCorner<3, 1>();
  std::vector<Vector3d> moved = points_of(source), back = points_of(target);
  for (Vector3d& p : moved) p = R * p + t;
  for (Vector3d& p : back) p = R.transpose() * (p - t);
  require_distances(of_source, moved, points_of(target));
  if (both) require_distances(of_target, back, points_of(source));
  return 0;
}
