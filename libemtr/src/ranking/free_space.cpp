#include "ranking/free_space.h"

#include <algorithm>

namespace emtr {
namespace {

std::vector<DepthMap> maps(const Surface& surface, const Viewpoints& viewpoints,
                           const Kernels& kernels) {
  std::vector<DepthMap> out;
  for (const Viewpoint& viewpoint : viewpoints.candidates)
    out.emplace_back(surface.points, viewpoint.at, surface.leaf, kernels);
  return out;
}

}  // namespace

FreeSpace::FreeSpace(const Surface& source, const Surface& target, const Viewpoints& of_source,
                     const Viewpoints& of_target, const Kernels& kernels)
    : source_(source),
      target_(target),
      of_source_(maps(source, of_source, kernels)),
      of_target_(maps(target, of_target, kernels)) {}

double FreeSpace::violation(const Cloud& source, const Cloud& target, const Rigid& pose,
                            double sign, Scratch& scratch) const {
  const Rigid back = pose.inverse();
  const auto share = [&](const DepthMap& map, const Cloud& points, const Rigid& moved) {
    return static_cast<double>(map.in_front(points, moved, scratch)) /
           static_cast<double>(points.size());
  };
  double s[2] = {}, t[2] = {};  // of the points in front of what the source's sensor saw, ...
  for (std::size_t i = 0; i < of_source_.size(); ++i) s[i] = share(of_source_[i], target, back);
  for (std::size_t i = 0; i < of_target_.size(); ++i) t[i] = share(of_target_[i], source, pose);

  double least = 1;
  const auto same_side = [sign](std::size_t i, std::size_t j) { return (i == j) == (sign > 0); };
  const std::size_t n = std::max<std::size_t>(of_source_.size(), 1),
                    m = std::max<std::size_t>(of_target_.size(), 1);
  const bool all = of_source_.empty() || of_target_.empty() || (n == 1 && m == 1) || sign == 0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < m; ++j)
      if (all || same_side(i, j)) least = std::min(least, (s[i] + t[j]) / 2);
  return least;
}

}  // namespace emtr
