#include "priors/prior.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/pose_distance.h"
#include "util/cancellation.h"
#include "util/constants.h"

namespace emtr {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr int kSteps = 500;
/// A seed farther from the admissible poses belongs to another answer; from a nearer one local
/// refinement can find the way to its answer.
constexpr PoseDistance kReach = {20 * kPi / 180, 0.3};

Rigid rigid(const Quaterniond& q, const Vector3d& t) { return {q.toRotationMatrix(), t}; }

}  // namespace

Prior::Prior(RotationLimits rotation, TranslationLimits translation, const Rigid& inside)
    : rotation_(std::move(rotation)), translation_(std::move(translation)), inside_(inside) {}

bool Prior::holds(const RotationLimits& rotation, const TranslationLimits& translation,
                  const Rigid& pose) {
  return rotation.excess(Quaterniond(pose.R)) <= kTolerance &&
         translation.excess(pose.R, pose.t) <= kTolerance + translation.rounding();
}

bool Prior::admits(const Rigid& pose) const { return holds(rotation_, translation_, pose); }

Rigid Prior::attempt(const RotationLimits& rotation, const TranslationLimits& translation,
                     const Rigid& pose) {
  Quaterniond q = Quaterniond(pose.R).normalized();
  Rigid out = rigid(q, pose.t);
  for (int k = 0; k < kSteps; ++k) {
    q = rotation.step(translation.step(q));
    const Eigen::Matrix3d R = q.toRotationMatrix();
    out = rigid(q, translation.nearest(R, pose.t));
    if (holds(rotation, translation, out)) break;
  }
  return out;
}

Rigid Prior::project(const Rigid& pose) const {
  if (admits(pose)) return pose;
  Rigid found = attempt(rotation_, translation_, pose);
  if (admits(found)) return found;
  const Quaterniond from(inside_.R), to(found.R);
  Rigid out = inside_;
  double in = 0, beyond = 1;
  for (int k = 0; k < 40; ++k) {
    const double s = (in + beyond) / 2;
    const Quaterniond q = from.slerp(s, to).normalized();
    const Rigid at = rigid(q, translation_.nearest(q.toRotationMatrix(), pose.t));
    if (admits(at)) {
      out = at;
      in = s;
    } else {
      beyond = s;
    }
  }
  return out;
}

std::vector<Rigid> admissible(const std::vector<Rigid>& poses, const Prior* prior) {
  if (!prior) return poses;
  std::vector<Rigid> out;
  for (const Rigid& pose : poses) {
    check_cancelled();
    const Rigid inside = prior->project(pose);
    if (is_same_pose(pose, inside, kReach)) out.push_back(inside);
  }
  return out;
}

}  // namespace emtr
