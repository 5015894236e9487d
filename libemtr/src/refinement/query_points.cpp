#include "refinement/query_points.h"

#include <algorithm>
#include <cmath>

#include "util/error.h"

namespace emtr {

QueryPoints::QueryPoints(const SharedSurface& surface, std::size_t count, std::size_t first_count)
    : surface_(surface) {
  const Cloud &p = surface->points, &n = surface->normals;
  if (n.size() != p.size())
    throw Error(EMTR_ERROR_ARGUMENT, "surface: expected a normal for each point");
  if (!(surface->leaf > 0)) throw Error(EMTR_ERROR_ARGUMENT, "surface: expected a leaf above 0");
  std::vector<std::int32_t> usable;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (!std::isnan(n.x[i])) usable.push_back(static_cast<std::int32_t>(i));
  const std::size_t all = std::min(count, usable.size()),
                    stride = std::max<std::size_t>(1, all / first_count);
  first_ = all ? (all - 1) / stride + 1 : 0;
  for (std::size_t phase = 0; phase < std::min(stride, all); ++phase)
    for (std::size_t k = phase; k < all; k += stride)
      rows_.push_back(usable[k * usable.size() / all]);
  positions_ = p.select(rows_);
}

}  // namespace emtr
