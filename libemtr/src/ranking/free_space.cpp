#include "ranking/free_space.h"

namespace emtr {

std::optional<FreeSpace::Seen> FreeSpace::seen(const Surface& surface,
                                               const std::optional<Viewpoint>& viewpoint,
                                               const Kernels& kernels) {
  if (!viewpoint || viewpoint->trust <= 0) return std::nullopt;
  return Seen{DepthMap(surface.points, viewpoint->at, surface.leaf, kernels), viewpoint->trust};
}

FreeSpace::FreeSpace(const Surface& source, const Surface& target,
                     const std::optional<Viewpoint>& source_viewpoint,
                     const std::optional<Viewpoint>& target_viewpoint, const Kernels& kernels)
    : by_source_(seen(source, source_viewpoint, kernels)),
      by_target_(seen(target, target_viewpoint, kernels)) {}

double FreeSpace::violation(const Points& source, const Points& target, const Rigid& pose,
                            Scratch& scratch) const {
  const auto share = [&](const std::optional<Seen>& seen, const Points& points,
                         const Rigid& moved) {
    if (!seen) return 0.0;
    const auto count =
        static_cast<double>(seen->map.in_front(points.cloud, moved, scratch, points.inlier.data()));
    return seen->trust * count / static_cast<double>(points.cloud.size());
  };
  return (share(by_source_, target, pose.inverse()) + share(by_target_, source, pose)) / 2;
}

}  // namespace emtr
