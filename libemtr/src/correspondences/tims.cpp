#include "correspondences/tims.h"

#include <cmath>

#include "util/cancellation.h"

namespace emtr {

Tims form_tims(const Cloud& source, const Cloud& target,
               const std::vector<Correspondence>& correspondences, double threshold) {
  // Prunes a little beyond the threshold, so that rounding cannot drop what task beta would count.
  const double limit = threshold * (1 + 1e-5) + 1e-6;
  struct Difference {
    float x, y, z;
    double length() const { return std::sqrt(double{x} * x + double{y} * y + double{z} * z); }
  };
  const auto difference = [](const Cloud& cloud, std::int32_t from, std::int32_t to) {
    const auto a = static_cast<std::size_t>(from), b = static_cast<std::size_t>(to);
    return Difference{cloud.x[b] - cloud.x[a], cloud.y[b] - cloud.y[a], cloud.z[b] - cloud.z[a]};
  };
  Tims tims;
  tims.ends_source = source.select(rows_of(correspondences, &Correspondence::source));
  tims.ends_target = target.select(rows_of(correspondences, &Correspondence::target));
  for (std::size_t j = 0; j < correspondences.size(); ++j) {
    check_cancelled();
    for (std::size_t k = j + 1; k < correspondences.size(); ++k) {
      const auto p = difference(source, correspondences[j].source, correspondences[k].source);
      const auto q = difference(target, correspondences[j].target, correspondences[k].target);
      if (std::abs(p.length() - q.length()) >= limit) {
        ++tims.pruned;
        continue;
      }
      tims.source.append(p.x, p.y, p.z);
      tims.target.append(q.x, q.y, q.z);
    }
  }
  return tims;
}

std::size_t correspondence_cap(std::size_t max_tims) {
  auto k = static_cast<std::size_t>((1 + std::sqrt(1 + 8.0 * static_cast<double>(max_tims))) / 2);
  while (k > 0 && k * (k - 1) / 2 > max_tims) --k;
  return k;
}

}  // namespace emtr
