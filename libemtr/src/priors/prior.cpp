#include "priors/prior.h"

#include <algorithm>
#include <cmath>

#include "geometry/pose_distance.h"
#include "util/cancellation.h"

namespace emtr {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using Rotation = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

constexpr int kSteps = 500;
/// Further from the admissible poses a seed is of another answer; nearer, the polish can find the
/// way to what the seed meant.
constexpr PoseDistance kReach = {20 * 3.14159265358979323846 / 180, 0.3};

Eigen::Matrix3d rotation_of(const Rigid& pose) { return Eigen::Map<const Rotation>(pose.R); }

Rigid rigid(const Quaterniond& q, const Vector3d& t) {
  Rigid out;
  Eigen::Map<Rotation>(out.R) = q.toRotationMatrix();
  Vector3d::Map(out.t) = t;
  return out;
}

}  // namespace

Prior::Prior(RotationLimits rotation, TranslationLimits translation, const Rigid& inside)
    : rotation_(std::move(rotation)), translation_(std::move(translation)), inside_(inside) {}

bool Prior::holds(const RotationLimits& rotation, const TranslationLimits& translation,
                  const Rigid& pose) {
  const Eigen::Matrix3d R = rotation_of(pose);
  return rotation.excess(Quaterniond(R)) <= kTolerance &&
         translation.excess(R, Vector3d::Map(pose.t)) <= kTolerance + translation.rounding();
}

bool Prior::admits(const Rigid& pose) const { return holds(rotation_, translation_, pose); }

Rigid Prior::attempt(const RotationLimits& rotation, const TranslationLimits& translation,
                     const Rigid& pose) {
  Quaterniond q = Quaterniond(rotation_of(pose)).normalized();
  const Vector3d t = Vector3d::Map(pose.t);
  Rigid out = rigid(q, t);
  for (int k = 0; k < kSteps; ++k) {
    q = rotation.step(translation.step(q));
    const Eigen::Matrix3d R = q.toRotationMatrix();
    out = rigid(q, translation.nearest(R, t));
    if (holds(rotation, translation, out)) break;
  }
  return out;
}

Rigid Prior::project(const Rigid& pose) const {
  if (admits(pose)) return pose;
  const Rigid found = attempt(rotation_, translation_, pose);
  if (admits(found)) return found;
  const Quaterniond from(rotation_of(inside_)), to(rotation_of(found));
  Rigid out = inside_;
  double in = 0, beyond = 1;
  for (int k = 0; k < 40; ++k) {
    const double s = (in + beyond) / 2;
    const Quaterniond q = from.slerp(s, to).normalized();
    const Rigid at = rigid(q, translation_.nearest(q.toRotationMatrix(), Vector3d::Map(pose.t)));
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
    if (within(pose, inside, kReach)) out.push_back(inside);
  }
  return out;
}

}  // namespace emtr
