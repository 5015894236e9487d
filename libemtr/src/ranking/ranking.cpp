#include "ranking/ranking.h"

#include <utility>

namespace emtr {
namespace {

constexpr double kMissWeight = 0.1;

SharedSurface oriented(const SharedSurface& surface, const std::optional<Viewpoint>& viewpoint) {
  if (!is_given(viewpoint)) return surface;
  Surface out = *surface;
  orient_normals(out.points, viewpoint->in_float(), out.normals);
  return SharedSurface(std::move(out));
}

}  // namespace

Ranking::Ranking(const SharedSurface& source, const SharedSurface& target,
                 const std::optional<Viewpoint>& source_viewpoint,
                 const std::optional<Viewpoint>& target_viewpoint, const Kernels& kernels)
    : both_given_(is_given(source_viewpoint) && is_given(target_viewpoint)),
      fit_(oriented(source, source_viewpoint), oriented(target, target_viewpoint), kernels),
      free_space_(*source, *target, source_viewpoint, target_viewpoint, kernels) {}

Ranking::Value Ranking::evaluate(const Rigid& pose, Scratch& scratch, std::size_t step) const {
  Value out;
  out.fit = fit_.evaluate(pose, step, scratch.fit);
  out.violation = free_space_.violation({fit_.points(0, step), scratch.fit.inlier[0]},
                                        {fit_.points(1, step), scratch.fit.inlier[1]}, pose,
                                        scratch.free_space);
  const double fit = both_given_ ? out.fit.same_side : out.fit.score;
  out.score = fit - kMissWeight * (out.fit.near - fit) - out.violation;
  return out;
}

}  // namespace emtr
