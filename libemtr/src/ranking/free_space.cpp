#include "ranking/free_space.h"

#include <algorithm>

namespace emtr {
namespace {

std::vector<DepthMap> depth_maps(const Surface& surface, const Viewpoints& viewpoints,
                                 const Kernels& kernels) {
  std::vector<DepthMap> out;
  for (const Viewpoint& viewpoint : viewpoints.candidates)
    out.emplace_back(surface.points, viewpoint.at, surface.leaf, kernels);
  return out;
}

}  // namespace

FreeSpace::FreeSpace(const Surface& source, const Surface& target,
                     const Viewpoints& source_viewpoints, const Viewpoints& target_viewpoints,
                     const Kernels& kernels)
    : source_(source),
      target_(target),
      source_maps_(depth_maps(source, source_viewpoints, kernels)),
      target_maps_(depth_maps(target, target_viewpoints, kernels)) {}

double FreeSpace::violation(const Cloud& source, const Cloud& target, const Rigid& pose,
                            double sign, Scratch& scratch) const {
  const Rigid inverse = pose.inverse();
  const auto share = [&](const DepthMap& map, const Cloud& points, const Rigid& moved) {
    return static_cast<double>(map.in_front(points, moved, scratch)) /
           static_cast<double>(points.size());
  };
  double s[2] = {}, t[2] = {};  // shares in front of what the source's (the target's) sensor saw
  for (std::size_t i = 0; i < source_maps_.size(); ++i)
    s[i] = share(source_maps_[i], target, inverse);
  for (std::size_t i = 0; i < target_maps_.size(); ++i) t[i] = share(target_maps_[i], source, pose);

  double minimum = 1;
  const auto same_side = [sign](std::size_t i, std::size_t j) { return (i == j) == (sign > 0); };
  const std::size_t n = std::max<std::size_t>(source_maps_.size(), 1),
                    m = std::max<std::size_t>(target_maps_.size(), 1);
  const bool all = source_maps_.empty() || target_maps_.empty() || (n == 1 && m == 1) || sign == 0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < m; ++j)
      if (all || same_side(i, j)) minimum = std::min(minimum, (s[i] + t[j]) / 2);
  return minimum;
}

}  // namespace emtr
