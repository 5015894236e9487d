#include "verdict/verdict.h"

#include <algorithm>
#include <limits>

#include "geometry/pose_distance.h"

namespace emtr {
namespace {

constexpr std::size_t kFewMatches = 10;

/// Returns the share of the distances that are below the scale of rho.
double inlier_ratio(const std::vector<float>& squared, double scale) {
  const auto limit = static_cast<float>(scale) * static_cast<float>(scale);
  const auto inliers =
      std::count_if(squared.begin(), squared.end(), [=](float d) { return d < limit; });
  return static_cast<double>(inliers) / static_cast<double>(squared.size());
}

/// Returns the mean dense fitness of the best pose that is a different answer; 1, the worst there
/// is, when the swarm remembers no other.
double best_alternative(const Evolution& evolution, const Rigid& best, const TaskAlpha& alpha) {
  TaskAlpha::Scratch scratch;
  double fitness = alpha.worst(EMTR_RESOLUTION_DENSE);
  for (const Hypothesis& h : evolution.hypotheses) {
    if (is_same_pose(h.pose, best, kDistinctPose)) continue;
    const bool known = evolution.resolution == EMTR_RESOLUTION_DENSE;
    fitness =
        std::min(fitness, known ? h.fitness
                                : alpha.evaluate(EMTR_RESOLUTION_DENSE, h.pose, fitness, scratch));
  }
  return fitness / alpha.worst(EMTR_RESOLUTION_DENSE);
}

}  // namespace

Verdict judge(const Evolution& evolution, const Rigid& pose, const TaskAlpha& alpha,
              std::size_t correspondences, const Settings& settings) {
  const double c = alpha.scale(EMTR_RESOLUTION_DENSE);
  const TaskAlpha::Residuals source = alpha.residuals_source(pose);
  const TaskAlpha::Residuals target = alpha.residuals_target(pose);

  Verdict v;
  v.fitness = (source.rho_sum + target.rho_sum) / alpha.worst(EMTR_RESOLUTION_DENSE);
  v.inlier_ratio_source = inlier_ratio(source.squared, c);
  v.inlier_ratio_target = inlier_ratio(target.squared, c);
  // After a stop nobody waits for fitness that is not known yet.
  const bool known = !evolution.hypotheses.empty() && evolution.resolution == EMTR_RESOLUTION_DENSE;
  v.fitness_gap = known || !evolution.stopped ? best_alternative(evolution, pose, alpha) - v.fitness
                                              : std::numeric_limits<double>::quiet_NaN();

  if (evolution.stopped)
    v.reason = EMTR_REASON_INTERRUPTED;
  else if (v.fitness > settings.maximum_fitness)
    v.reason = correspondences < kFewMatches ? EMTR_REASON_FEW_MATCHES : EMTR_REASON_LOW_OVERLAP;
  else if (v.fitness_gap < settings.minimum_fitness_gap)
    v.reason = EMTR_REASON_AMBIGUOUS;
  else
    v.reason = EMTR_REASON_REGISTERED;
  v.registered = v.reason == EMTR_REASON_REGISTERED;
  return v;
}

}  // namespace emtr
