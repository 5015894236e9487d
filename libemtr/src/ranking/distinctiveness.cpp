#include "ranking/distinctiveness.h"

#include <cmath>

namespace emtr {
namespace {

constexpr float kMinimumCosine = 0.94f;  // of normals that face the same way
constexpr float kFloor = 0.02f;          // of rho: rarer than this is not more telling
constexpr std::size_t kSamples = 1024;   // normals that stand for all

/// Returns normals from all over the cloud. No fixed step: the points may come in a pattern.
Cloud sample(const Cloud& normals) {
  constexpr double kGolden = 0.6180339887498949;
  if (normals.size() <= kSamples) return normals;
  std::vector<std::size_t> rows(kSamples);
  for (std::size_t k = 0; k < kSamples; ++k) {
    const double position = kGolden * static_cast<double>(k);
    rows[k] = static_cast<std::size_t>((position - std::floor(position)) *
                                       static_cast<double>(normals.size()));
  }
  return normals.select(rows);
}

}  // namespace

std::vector<float> distinctiveness(const Surface& surface) {
  const Cloud& normals = surface.normals;
  const Cloud some = sample(normals);
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

}  // namespace emtr
