#include "correspondences/tims.h"

#include <cmath>

#include "util/cancellation.h"

namespace emtr {

Tims form_tims(const Cloud& source, const Cloud& target,
               const std::vector<Correspondence>& correspondences, double threshold) {
  // Kept a little beyond the threshold, so that rounding cannot drop what task beta would count.
  const double limit = threshold * (1 + 1e-5) + 1e-6;
  struct Difference {
    float x, y, z;
    double length() const { return std::sqrt(double{x} * x + double{y} * y + double{z} * z); }
  };
  const auto difference = [](const Cloud& cloud, std::int32_t from, std::int32_t to) {
    const auto a = static_cast<std::size_t>(from), b = static_cast<std::size_t>(to);
    return Difference{cloud.x[b] - cloud.x[a], cloud.y[b] - cloud.y[a], cloud.z[b] - cloud.z[a]};
  };
  const auto append = [](Cloud& cloud, const Difference& d) {
    cloud.x.push_back(d.x);
    cloud.y.push_back(d.y);
    cloud.z.push_back(d.z);
  };
  const auto point = [](const Cloud& cloud, std::int32_t row) {
    const auto i = static_cast<std::size_t>(row);
    return Difference{cloud.x[i], cloud.y[i], cloud.z[i]};
  };
  Tims tims;
  for (const Correspondence& c : correspondences) {
    append(tims.ends_source, point(source, c.source));
    append(tims.ends_target, point(target, c.target));
  }
  for (std::size_t j = 0; j < correspondences.size(); ++j) {
    check_cancelled();
    for (std::size_t k = j + 1; k < correspondences.size(); ++k) {
      const auto p = difference(source, correspondences[j].source, correspondences[k].source);
      const auto q = difference(target, correspondences[j].target, correspondences[k].target);
      if (std::abs(p.length() - q.length()) >= limit) {
        ++tims.pruned;
        continue;
      }
      append(tims.source, p);
      append(tims.target, q);
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
