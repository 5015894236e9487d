#include "prepared_cloud.h"

#include <algorithm>

#include "../features/resolution.h"
#include "base_points.h"

namespace emtr {

PreparedCloud::PreparedCloud(const emtr_cloud& cloud, const std::string& name, int threads) {
  const std::string title = name.empty() ? "cloud" : name + " cloud";
  const CloudReader reader(cloud, title);
  if (reader.count() <= kThinnedAbove) threads = 1;  // sooner done than others are awake
  const Extent extent = measure(reader, title, threads);
  count = extent.count;
  dropped = reader.count() - count;
  std::copy_n(extent.center, 3, center);
  radius = extent.radius;
  base = base_points(reader, extent, threads);
}

double PreparedCloud::spacing() const {
  constexpr std::size_t enough = 2000;  // for a mean to a per cent or so
  std::call_once(spacing_once_, [this] { spacing_ = mean_spacing(base, enough); });
  return spacing_;
}

}  // namespace emtr
