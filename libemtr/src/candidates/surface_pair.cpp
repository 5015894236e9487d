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

SurfacePair::SurfacePair(Surface source, Surface target, const Viewpoints& of_source,
                   const Viewpoints& of_target, const Kernels& kernels)
    : source_(std::move(source)),
      target_(std::move(target)),
      ranking_(source_, target_, of_source, of_target, kernels),
      near_target_(neighbors(target_, kernels)),
      local_refinement_(source_, target_, nullptr, near_target_.get(), coarse_refinement(), kernels) {
  ranking_.fit().prepare(kQuickStep);
}

Surface surface(const Cloud& cloud, const Features& features, double leaf) {
  Surface out{cloud, {}, leaf};
  out.normals.resize(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    out.normals.x[i] = features.normals[3 * i];
    out.normals.y[i] = features.normals[3 * i + 1];
    out.normals.z[i] = features.normals[3 * i + 2];
  }
  return out;
}

}  // namespace emtr
