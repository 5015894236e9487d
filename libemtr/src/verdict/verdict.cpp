#include "verdict.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "../candidates/modes.h"

namespace emtr {
namespace {

constexpr std::size_t kFewMatches = 10;

struct Inliers {
  double ratio, squared_sum;
  std::size_t count;
};

Inliers inliers(const std::vector<float>& squared, double scale) {
  const auto limit = static_cast<float>(scale) * static_cast<float>(scale);
  Inliers out{0, 0, 0};
  for (const float d : squared)
    if (d < limit) {
      ++out.count;
      out.squared_sum += static_cast<double>(d);
    }
  out.ratio = static_cast<double>(out.count) / static_cast<double>(squared.size());
  return out;
}

/// Mean dense fitness of the best pose that is a mode of its own; 1, the worst there is, when the
/// swarm remembers no other.
double other_mode(const Evolution& evolution, const Rigid& best, const TaskAlpha& alpha) {
  TaskAlpha::Scratch scratch;
  double other = alpha.worst(EMTR_STAGE_DENSE);
  for (const Hypothesis& h : evolution.hypotheses) {
    if (within(h.pose, best, kMode)) continue;
    const bool known = evolution.stage == EMTR_STAGE_DENSE;
    other = std::min(other, known ? h.fitness : alpha.evaluate(EMTR_STAGE_DENSE, h.pose, scratch));
  }
  return other / alpha.worst(EMTR_STAGE_DENSE);
}

}  // namespace

Verdict judge(const Evolution& evolution, const Rigid& pose, const TaskAlpha& alpha,
              std::size_t correspondences, const Settings& settings) {
  const double c = alpha.scale(EMTR_STAGE_DENSE);
  const TaskAlpha::Residuals source = alpha.residuals_source(pose);
  const TaskAlpha::Residuals target = alpha.residuals_target(pose);

  Verdict v;
  v.fitness = (source.rho_sum + target.rho_sum) / alpha.worst(EMTR_STAGE_DENSE);
  const Inliers from_source = inliers(source.squared, c), from_target = inliers(target.squared, c);
  v.inlier_ratio_source = from_source.ratio;
  v.inlier_ratio_target = from_target.ratio;
  v.inlier_rmse = from_source.count
                      ? std::sqrt(from_source.squared_sum / static_cast<double>(from_source.count))
                      : std::numeric_limits<double>::quiet_NaN();
  // Of a run that was stopped nobody waits for fitness that is not known yet.
  const bool known = !evolution.hypotheses.empty() && evolution.stage == EMTR_STAGE_DENSE;
  v.mode_gap = known || !evolution.stopped ? other_mode(evolution, pose, alpha) - v.fitness
                                           : std::numeric_limits<double>::quiet_NaN();

  if (evolution.stopped)
    v.reason = EMTR_REASON_INTERRUPTED;
  else if (v.fitness > settings.maximum_fitness)
    v.reason = correspondences < kFewMatches ? EMTR_REASON_FEW_MATCHES : EMTR_REASON_LOW_OVERLAP;
  else if (v.mode_gap < settings.minimum_mode_gap)
    v.reason = EMTR_REASON_AMBIGUOUS;
  else
    v.reason = EMTR_REASON_REGISTERED;
  v.registered = v.reason == EMTR_REASON_REGISTERED;
  return v;
}

}  // namespace emtr
