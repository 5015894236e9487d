#include "report/unit_hint.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "read/vector_field.h"
#include "text/numbers.h"

namespace cli {
namespace {

struct Units {
  double factor;
  const char* names;
};

constexpr Units kUnits[] = {{10, "millimeters and centimeters"},
                            {25.4, "millimeters and inches"},
                            {100, "centimeters and meters"},
                            {304.8, "millimeters and feet"},
                            {1000, "millimeters and meters"}};
constexpr double kNear = 1.6;           // the extents of two parts of one thing differ too
constexpr std::size_t kLooked = 20000;  // points of a cloud that are looked at

/// Returns the diagonal of the box that has all but one in a hundred points on each side.
double extent(const CloudFile& cloud) {
  const VectorField field = require_vector(cloud, {"x", "y", "z"});
  const std::size_t step = std::max<std::size_t>(1, cloud.size() / kLooked);
  std::vector<double> values[3];
  for (std::size_t i = 0; i < cloud.size(); i += step) {
    const Eigen::Vector3d p = field.get(cloud.blob.data.data() + i * cloud.blob.point_step);
    if (!p.allFinite()) continue;
    for (int axis = 0; axis < 3; ++axis) values[axis].push_back(p[axis]);
  }
  double squares = 0;
  for (auto& axis : values) {
    if (axis.empty()) return 0;
    std::sort(axis.begin(), axis.end());
    const std::size_t out = axis.size() / 100;
    const double side = axis[axis.size() - 1 - out] - axis[out];
    squares += side * side;
  }
  return std::sqrt(squares);
}

}  // namespace

UnitHint unit_hint(const CloudFile& source, const CloudFile& target) {
  UnitHint hint;
  const double from = extent(source), to = extent(target);
  if (!(from > 0) || !(to > 0) || !std::isfinite(from / to)) return hint;
  hint.ratio = from / to;
  const double larger = std::max(hint.ratio, 1 / hint.ratio);
  double nearest = kNear;
  const Units* found = nullptr;
  for (const Units& units : kUnits) {
    const double apart = std::max(larger / units.factor, units.factor / larger);
    if (apart > nearest) continue;
    nearest = apart;
    found = &units;
  }
  if (!found) return hint;
  const bool source_larger = hint.ratio > 1;
  hint.factor = source_larger ? found->factor : 1 / found->factor;
  hint.text = std::string("the ") + (source_larger ? "source" : "target") + " is about " +
              rounded(larger) + " times as large as the " + (source_larger ? "target" : "source") +
              ": are they in different units, such as " + found->names +
              "? --scale units tries such factors";
  return hint;
}

}  // namespace cli
