#include "ranking/ranking.h"

#include <utility>

namespace emtr {
namespace {

constexpr double kViolationWeight = 2;

SharedSurface oriented(const SharedSurface& surface, const Viewpoints& viewpoints) {
  if (viewpoints.candidates.empty()) return surface;
  Surface out = *surface;
  orient_normals(out.points, viewpoints.candidates.front().in_float(), out.normals);
  return SharedSurface(std::move(out));
}

}  // namespace

Ranking::Ranking(const SharedSurface& source, const SharedSurface& target,
                 const Viewpoints& source_viewpoints, const Viewpoints& target_viewpoints,
                 const Kernels& kernels)
    : source_(oriented(source, source_viewpoints)),
      target_(oriented(target, target_viewpoints)),
      both_given_(source_viewpoints.candidates.size() == 1 &&
                  target_viewpoints.candidates.size() == 1),
      fit_(source_, target_, kernels),
      free_space_(*source_, *target_, source_viewpoints, target_viewpoints, kernels) {}

Ranking::Value Ranking::evaluate(const Rigid& pose, Scratch& scratch, double minimum) const {
  Value out;
  out.fit = fit_.evaluate(pose, scratch.fit);
  out.score = both_given_ ? out.fit.same_side : out.fit.score;
  if (out.score <= minimum) return out;
  out.violation = free_space_.violation(pose, out.fit.sign, scratch.free_space);
  out.score -= kViolationWeight * out.violation;
  return out;
}

Ranking::Value Ranking::quick(const Rigid& pose, std::size_t step, Scratch& scratch) const {
  Value out;
  out.fit = fit_.evaluate(pose, step, scratch.fit);
  out.violation = free_space_.violation(fit_.points(0, step), fit_.points(1, step), pose,
                                        out.fit.sign, scratch.free_space);
  out.score = (both_given_ ? out.fit.same_side : out.fit.score) - kViolationWeight * out.violation;
  return out;
}

}  // namespace emtr
