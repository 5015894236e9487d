#include "ranking.h"

namespace emtr {
namespace {

constexpr float kReach = 4;  // leaves that coarse_polish() asks for
constexpr float kCell = 1.5;

std::unique_ptr<Neighbors> neighbors(const Surface& surface, const Kernels& kernels) {
  const auto leaf = static_cast<float>(surface.leaf);
  return make_candidate_grid(surface.points, kReach * leaf, kCell * leaf, kernels);
}

Surface oriented(Surface surface, const Viewpoints& viewpoints) {
  if (!viewpoints.candidates.empty()) orient(surface, viewpoints.candidates.front());
  return surface;
}

}  // namespace

Ranking::Ranking(Surface source, Surface target, const Kernels& kernels)
    : source_(std::move(source)),
      target_(std::move(target)),
      fit_(source_, target_, kernels),
      near_target_(neighbors(target_, kernels)),
      polish_(source_, target_, nullptr, near_target_.get(), coarse_polish(), kernels) {
  fit_.prepare(kQuickStep);
}

Ranking::Ranking(const Ranking& other, Viewpoints of_source, Viewpoints of_target,
                 const Kernels& kernels)
    : Ranking(oriented(other.source_, of_source), oriented(other.target_, of_target), kernels) {
  of_source_ = std::move(of_source);
  of_target_ = std::move(of_target);
  free_space_ = std::make_unique<FreeSpace>(source_, target_, of_source_, of_target_, kernels);
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
