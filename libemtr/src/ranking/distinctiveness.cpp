#include "ranking/distinctiveness.h"

#include <cmath>

#include "geometry/spread_rows.h"

namespace emtr {
namespace {

constexpr float kMinimumCosine = 0.94f;  // of normals that face the same way
constexpr float kFloor = 0.02f;          // of rho: rarer than this is not more telling
constexpr std::size_t kSamples = 1024;   // normals that stand for all

}  // namespace

std::vector<float> distinctiveness(const Surface& surface) {
  const Cloud& normals = surface.normals;
  if (!surface.weighted) return std::vector<float>(normals.size(), 1);
  const Cloud some = normals.select(spread_rows(normals.size(), kSamples));
  const auto count = static_cast<float>(some.size());
  std::vector<float> out(normals.size());
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const float x = normals.x[i], y = normals.y[i], z = normals.z[i];
    if (!std::isfinite(x)) continue;
    int alike = 0;
    for (std::size_t k = 0; k < some.size(); ++k)
      alike += std::abs((x * some.x[k] + y * some.y[k]) + z * some.z[k]) > kMinimumCosine;
    const float rho = static_cast<float>(alike) / count + kFloor;
    out[i] = 1 / (rho * std::sqrt(rho));
  }
  return out;
}

std::size_t least_distinctive(const std::vector<float>& weights) {
  std::size_t least = 0;
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (weights[i] > 0 && (weights[least] <= 0 || weights[i] < weights[least])) least = i;
  return least;
}

}  // namespace emtr
