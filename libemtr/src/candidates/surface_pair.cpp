#include "candidates/surface_pair.h"

namespace emtr {
namespace {

constexpr float kReach = 4;  // leaves that coarse_refinement() asks for
constexpr float kCell = 1.5;

std::unique_ptr<Neighbors> neighbors(const Surface& surface, const Kernels& kernels) {
  const auto leaf = static_cast<float>(surface.leaf);
  return make_candidate_grid(surface.points, kReach * leaf, kCell * leaf, kernels);
}

}  // namespace

SurfacePair::SurfacePair(const SharedSurface& source, const SharedSurface& target,
                         const Viewpoints& source_viewpoints, const Viewpoints& target_viewpoints,
                         const Kernels& kernels)
    : source_(source),
      target_(target),
      ranking_(source_, target_, source_viewpoints, target_viewpoints, kernels),
      near_target_(neighbors(*target_, kernels)),
      local_refinement_(source_, target_, nullptr, near_target_.get(), coarse_refinement(),
                        kernels) {
  ranking_.fit().add_subset(kQuickStep);
}

Surface surface(const Cloud& cloud, const Features& features, double leaf) {
  Surface out{cloud, {}, leaf};
  out.normals.resize(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) out.normals.set(i, &features.normals[3 * i]);
  return out;
}

}  // namespace emtr
