#include "verdict.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace emtr {
namespace {

// Two poses are different modes when they differ by more than this.
constexpr double kModeAngle = 10 * 3.14159265358979323846 / 180;
constexpr double kModeOffset = 0.15;  // of the source's centroid, radii
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

bool different(const Rigid& a, const Rigid& b) {
  const double offset = std::hypot(a.t[0] - b.t[0], a.t[1] - b.t[1], a.t[2] - b.t[2]);
  return rotation_distance(a.R, b.R) > kModeAngle || offset > kModeOffset;
}

/// Mean dense fitness of the best pose that is a mode of its own; 1, the worst there is, when the
/// swarm remembers no other.
double other_mode(const Evolution& evolution, const TaskAlpha& alpha) {
  const Rigid& best = evolution.hypotheses[evolution.best].pose;
  TaskAlpha::Scratch scratch;
  double other = alpha.worst(EMTR_STAGE_DENSE);
  for (const Hypothesis& h : evolution.hypotheses) {
    if (!different(h.pose, best)) continue;
    const bool known = evolution.stage == EMTR_STAGE_DENSE;
    other = std::min(other, known ? h.fitness : alpha.evaluate(EMTR_STAGE_DENSE, h.pose, scratch));
  }
  return other / alpha.worst(EMTR_STAGE_DENSE);
}

}  // namespace

Verdict judge(const Evolution& evolution, const TaskAlpha& alpha, std::size_t correspondences,
              const Settings& settings) {
  const Rigid& pose = evolution.hypotheses[evolution.best].pose;
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
  v.mode_gap = other_mode(evolution, alpha) - v.fitness;

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
