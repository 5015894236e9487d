#include "candidates/surface_pair.h"

namespace emtr {
namespace {

constexpr float kReach = 4;         // leaves that coarse_refinement() asks for
constexpr double kQueries = 1.5e5;  // of a registration without a fallback search, about

SharedNeighbors near(const SharedSurface& surface, const Kernels& kernels) {
  const auto leaf = static_cast<float>(surface->leaf);
  return *surface.memo().get<SharedNeighbors>({kReach, kQueries}, [&] {
    return make_neighbors(surface->points, kReach * leaf, kQueries, kernels);
  });
}

}  // namespace

SurfacePair::SurfacePair(const SharedSurface& source, const SharedSurface& target,
                         const std::optional<Viewpoint>& source_viewpoint,
                         const std::optional<Viewpoint>& target_viewpoint, const Kernels& kernels)
    : source_(source),
      target_(target),
      source_viewpoint_(source_viewpoint),
      target_viewpoint_(target_viewpoint),
      ranking_(source_, target_, source_viewpoint, target_viewpoint, kernels),
      near_target_(near(target_, kernels)),
      local_refinement_(source_, target_, nullptr, near_target_.get(), coarse_refinement(),
                        kernels) {
  ranking_.fit().add_subset(kQuickStep);
  ranking_.fit().add_subset(kQuickestStep);
}

void SurfacePair::make_ahead(const SharedSurface& target, const Kernels& kernels) {
  near(target, kernels);
}

Surface surface(const Cloud& cloud, const Features& features, double leaf) {
  Surface out{cloud, {}, leaf};
  out.normals.resize(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) out.normals.set(i, &features.normals[3 * i]);
  return out;
}

}  // namespace emtr
