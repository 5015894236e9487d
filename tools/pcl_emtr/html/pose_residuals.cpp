#include "html/pose_residuals.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "failure.h"
#include "html/base64.h"
#include "read/coordinates.h"

namespace cli {
namespace {

using Point = std::array<double, 3>;

/// Appends the points moved by a pose. The products are summed term by term, as Python does.
void append_moved(const std::vector<Point>& points, const double (&pose)[16],
                  std::vector<Point>& out) {
  for (const Point& p : points) {
    Point moved;
    for (std::size_t i = 0; i < 3; ++i) {
      const double* row = pose + 4 * i;
      moved[i] = row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + row[3];
    }
    out.push_back(moved);
  }
}

Json entry(const double* distances, std::size_t count) {
  const double maximum = *std::max_element(distances, distances + count);
  std::vector<std::uint16_t> steps(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double share = maximum > 0 ? distances[i] / maximum : 0;
    steps[i] = static_cast<std::uint16_t>(std::floor(share * 65535 + 0.5));
  }
  return {{"maximum", maximum}, {"values", base64(steps)}};
}

}  // namespace

Json pose_residuals(const std::vector<Point>& points, const CloudFile& target,
                    const Options& options, const emtr_result& result) {
  std::vector<Point> moved;  // under all poses: the target's kd-tree is built once
  append_moved(points, result.transformation, moved);
  for (std::size_t i = 0; i < result.alternative_count; ++i)
    append_moved(points, result.alternatives[i].transformation, moved);
  emtr_cloud from = {};
  from.points = moved.data();
  from.count = moved.size();
  from.scalar = EMTR_FLOAT64;
  std::vector<double> copy, distances(moved.size());
  const emtr_cloud to = coordinates(target, copy);
  const emtr_status status =
      emtr_residuals(&from, &to, nullptr, options.settings.threads, distances.data(), nullptr);
  if (status != EMTR_OK)
    throw Failure(kInputOutput, std::string("--html: ") + emtr_error_message());
  Json out = Json::array();
  for (std::size_t begin = 0; begin < distances.size(); begin += points.size())
    out.push_back(entry(distances.data() + begin, points.size()));
  return out;
}

}  // namespace cli
