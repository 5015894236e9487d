#include "candidates/rivals.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "candidates/quick_scores.h"
#include "candidates/scene_axes.h"
#include "geometry/pose_distance.h"
#include "geometry/rotation_vector.h"
#include "util/constants.h"

namespace emtr {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Returns the rotation about an axis through a point.
Rigid rotation_about(const Vector3d& axis, double cosine, double sine, const Vector3d& through) {
  Rigid out;
  out.R = cosine * Matrix3d::Identity() + sine * cross_matrix(axis) +
          (1 - cosine) * axis * axis.transpose();
  out.t = through - out.rotate(through);
  return out;
}

struct Scored {
  double score;
  Rigid pose;
};

/// Returns the kMostPeaks best, the best first.
std::vector<Rigid> best_of(std::vector<Scored> found) {
  std::stable_sort(found.begin(), found.end(),
                   [](const Scored& a, const Scored& b) { return a.score > b.score; });
  std::vector<Rigid> out;
  for (std::size_t i = 0; i < std::min(found.size(), kMostPeaks); ++i) out.push_back(found[i].pose);
  return out;
}

/// Returns the angles of all symmetries of three to twelve folds but for quarters, in radians.
std::vector<double> angles_of_folds() {
  constexpr int kMostFolds = 12;
  std::vector<double> out;
  for (int folds = 3; folds <= kMostFolds; ++folds)
    for (int k = 1; k < folds; ++k) {
      const bool quarter = 4 * k % folds == 0;
      if (!quarter && std::gcd(k, folds) == 1) out.push_back(2 * kPi * k / folds);
    }
  return out;
}

}  // namespace

std::vector<Rigid> quarter_rotated_rivals(const SurfacePair& surfaces, const Rigid& best) {
  constexpr double cosine[] = {1, 0, -1, 0}, sine[] = {0, 1, 0, -1};
  const SceneAxes scene = scene_axes(surfaces, best);
  std::vector<Rigid> out;
  for (const Vector3d& axis : scene.axes)
    for (int quarters = 1; quarters < 4; ++quarters)
      for (const Vector3d& through : {scene.mean, scene.middle})
        out.push_back(rotation_about(axis, cosine[quarters], sine[quarters], through) * best);
  return suppress_non_maxima(out, kDuplicatePose, out.size());
}

std::vector<Rigid> rotated_rivals(const SurfacePair& surfaces, const Rigid& best,
                                  ThreadTeam& team) {
  constexpr double kPromising = 0.3;  // scans from two sides overlap less in a wrong rotation
  const SceneAxes scene = scene_axes(surfaces, best);
  std::vector<Rigid> poses{best};
  for (const Vector3d& axis : scene.axes)
    for (const double angle : angles_of_folds())
      poses.push_back(rotation_about(axis, std::cos(angle), std::sin(angle), scene.mean) * best);
  const std::vector<double> scores = promising_quick_scores(surfaces, poses, 0, kPromising, team);
  std::vector<Scored> found;
  for (std::size_t i = 1; i < poses.size(); ++i)
    if (scores[i] > kPromising * std::max(scores[0], 0.0)) found.push_back({scores[i], poses[i]});
  return best_of(found);
}

std::vector<Rigid> translated_rivals(const SurfacePair& surfaces, const Rigid& best,
                                     ThreadTeam& team) {
  constexpr double kStep = 1.5;       // leaves, as far as a fit reaches
  constexpr double kPromising = 0.4;  // of the best's own score by so few
  const double step = kStep * std::max(surfaces.source().leaf, surfaces.target().leaf);
  const auto steps = static_cast<int>(kFarthestTranslation / step);
  const auto nearest = static_cast<int>(kDistinctPose.translation / step);
  std::vector<Rigid> poses;
  const std::vector<Vector3d> axes = scene_axes(surfaces, best).axes;
  for (const Vector3d& axis : axes)
    for (int k = -steps; k <= steps; ++k) {
      poses.push_back(best);
      poses.back().t += k * step * axis;
    }
  const std::vector<double> scores =
      promising_quick_scores(surfaces, poses, static_cast<std::size_t>(steps), kPromising, team);
  std::vector<Scored> found;
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    const std::size_t middle =
        axis * (2 * static_cast<std::size_t>(steps) + 1) + static_cast<std::size_t>(steps);
    const double* score = &scores[middle];
    const Rigid* pose = &poses[middle];
    const double enough = kPromising * std::max(score[0], 0.0);
    for (int k = 1 - steps; k < steps; ++k) {
      const bool peak = score[k] >= score[k - 1] && score[k] > score[k + 1];
      if (peak && std::abs(k) > nearest && score[k] > enough) found.push_back({score[k], pose[k]});
    }
  }
  return best_of(found);
}

}  // namespace emtr
