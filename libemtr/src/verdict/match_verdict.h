#pragma once

#include <emtr/emtr.h>

#include <vector>

#include "refinement/refine.h"
#include "seeds/match_pose.h"
#include "settings/settings.h"

namespace emtr {

/// What may be believed of a pose that matches alone decide.
struct MatchVerdict {
  double confidence = 0;  ///< estimated probability that the pose is right; a multiple of 1e-6
  emtr_reason reason = EMTR_REASON_FEW_MATCHES;
};

/// Judges the first of the poses by how many wrong matches would agree as well by chance, and by
/// the rival, if there is one. `unconstrained`: the inliers leave some direction open.
MatchVerdict judge_matches(const std::vector<MatchPose>& poses, bool unconstrained,
                           const Settings& settings);

/// Returns the pose with its information matrix and the directions that its inliers leave
/// unconstrained: those in which their noise moves the pose by more than a twentieth of their
/// radius. `prior`: admits the pose, and takes away some of these directions; or null.
Refined constraints_of(const MatchPoints& matches, const MatchPose& found, const Prior* prior);

}  // namespace emtr
