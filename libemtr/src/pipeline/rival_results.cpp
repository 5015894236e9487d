#include "pipeline/rival_results.h"

#include <algorithm>

#include "geometry/pose_distance.h"
#include "geometry/rigid.h"
#include "verdict/confidence.h"

namespace emtr {
namespace {

/// Returns where the small cloud is moved to, in its radii.
Rigid moved(const Result& result, const SmallCloud& small) {
  Rigid pose = from_matrix(result.transformation);
  if (!small.is_source) pose = pose.inverse();
  pose.t = (pose * Eigen::Vector3d::Map(small.cloud.center)) / small.cloud.radius;
  return pose;
}

/// Adds the pose to the alternatives, in the order of their scores.
void add_alternative(const Result& rival, Result& best) {
  emtr_alternative& out = best.others.emplace_back();
  std::copy_n(rival.transformation, 16, out.transformation);
  out.score = std::min(rival.score, best.score);
  out.surface_fit = rival.surface_fit;
  out.violation = rival.violation;
  out.evidence = rival.evidence;
  std::stable_sort(best.others.begin(), best.others.end(),
                   [](const auto& a, const auto& b) { return a.score > b.score; });
  best.alternatives = best.others.data();
  best.alternative_count = best.others.size();
  best.score_gap = best.score - best.others.front().score;
}

}  // namespace

bool is_stopped(const Result& result) {
  return result.reason == EMTR_REASON_INTERRUPTED || result.reason == EMTR_REASON_TIME_LIMIT;
}

void add_rivals(const std::vector<const Result*>& rivals, double minimum, Result& best) {
  for (const Result* rival : rivals) add_alternative(*rival, best);
  if (rivals.empty() || best.reason == EMTR_REASON_AMBIGUOUS) return;
  best.confidence = lower_for_rival(best.confidence);
  best.registered = best.confidence >= minimum;
  if (!best.registered && !is_stopped(best)) best.reason = EMTR_REASON_AMBIGUOUS;
}

void weigh_rivals(const std::vector<const Result*>& others, const SmallCloud& small, double minimum,
                  Result& best) {
  const Rigid pose = moved(best, small);
  std::vector<const Result*> rivals;
  for (const Result* other : others)
    if (is_rival_score(other->score, best.score) &&  // not without a score either
        !is_same_pose(moved(*other, small), pose, kDistinctPose))
      rivals.push_back(other);
  add_rivals(rivals, minimum, best);
}

}  // namespace emtr
