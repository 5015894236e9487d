#include "ranking/direction_bins.h"

namespace emtr {
namespace {

constexpr double kQuarter =
    1.5707963267948966;                   // the angle that a face sees: a quarter of a circle
constexpr double kMaximumBins = 1 << 18;  // along an edge: all that floats can tell apart

}  // namespace

DirectionBins::DirectionBins(const double viewpoint[3], const double facing[3], double size) {
  side_ = static_cast<std::int32_t>(std::clamp(std::round(kQuarter / size), 1.0, kMaximumBins));
  half_side_ = 0.5f * static_cast<float>(side_);

  double z[3], length = 0;
  for (int a = 0; a < 3; ++a) {
    z[a] = facing[a] - viewpoint[a];
    length += z[a] * z[a];
  }
  if (length == 0) z[2] = length = 1;  // any way is as good as another
  length = std::sqrt(length);
  for (double& v : z) v /= length;
  // x: across z, and the axis that is farthest from z.
  int axis = 0;
  for (int a = 1; a < 3; ++a)
    if (std::abs(z[a]) < std::abs(z[axis])) axis = a;
  double x[3] = {-z[axis] * z[0], -z[axis] * z[1], -z[axis] * z[2]};
  x[axis] += 1;
  length = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
  for (double& v : x) v /= length;
  const double y[3] = {z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2],
                       z[0] * x[1] - z[1] * x[0]};
  const double* rows[3] = {x, y, z};
  for (int r = 0; r < 3; ++r) {
    to_view_.t[r] = 0;
    for (int c = 0; c < 3; ++c) {
      to_view_.R(r, c) = rows[r][c];
      to_view_.t[r] -= rows[r][c] * viewpoint[c];
    }
  }
}

}  // namespace emtr
