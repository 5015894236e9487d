#include "ranking/ranking.h"

#include <utility>

namespace emtr {
namespace {

constexpr double kWeight = 2;  // of violations

Surface oriented(Surface surface, const Viewpoints& viewpoints) {
  if (!viewpoints.candidates.empty()) orient(surface, viewpoints.candidates.front());
  return surface;
}

}  // namespace

Ranking::Ranking(Surface source, Surface target, const Viewpoints& of_source,
                 const Viewpoints& of_target, const Kernels& kernels)
    : source_(oriented(std::move(source), of_source)),
      target_(oriented(std::move(target), of_target)),
      both_given_(of_source.candidates.size() == 1 && of_target.candidates.size() == 1),
      fit_(source_, target_, kernels),
      free_space_(source_, target_, of_source, of_target, kernels) {}

Ranking::Value Ranking::evaluate(const Rigid& pose, Scratch& scratch, double least) const {
  Value out;
  out.fit = fit_.evaluate(pose, scratch.fit);
  out.score = both_given_ ? out.fit.same_side : out.fit.score;
  if (out.score <= least) return out;
  out.violation = free_space_.violation(pose, out.fit.sign, scratch.free_space);
  out.score -= kWeight * out.violation;
  return out;
}

Ranking::Value Ranking::quick(const Rigid& pose, std::size_t step, Scratch& scratch) const {
  Value out;
  out.fit = fit_.evaluate(pose, step, scratch.fit);
  out.violation = free_space_.violation(fit_.points(0, step), fit_.points(1, step), pose,
                                        out.fit.sign, scratch.free_space);
  out.score = (both_given_ ? out.fit.same_side : out.fit.score) - kWeight * out.violation;
  return out;
}

}  // namespace emtr
