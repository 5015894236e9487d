#include "candidates/rivals.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "candidates/scene_axes.h"
#include "geometry/pose_distance.h"
#include "geometry/rotation_vector.h"

namespace emtr {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Returns the rotation by `quarters` times 90 degrees about an axis through a point.
Rigid quarter_rotations(const Vector3d& axis, int quarters, const Vector3d& through) {
  constexpr double cosine[] = {1, 0, -1, 0}, sine[] = {0, 1, 0, -1};
  Rigid out;
  out.R = cosine[quarters] * Matrix3d::Identity() + sine[quarters] * cross_matrix(axis) +
          (1 - cosine[quarters]) * axis * axis.transpose();
  out.t = through - out.rotate(through);
  return out;
}

constexpr double kStep = 1.5;       // leaves, as far as a fit reaches
constexpr double kPromising = 0.4;  // of the best's own score by so few

}  // namespace

std::vector<Rigid> rotated_rivals(const SurfacePair& surfaces, const Rigid& best) {
  const SceneAxes scene = scene_axes(surfaces, best);
  std::vector<Rigid> out;
  for (const Vector3d& axis : scene.axes)
    for (int quarters = 1; quarters < 4; ++quarters)
      for (const Vector3d& through : {scene.mean, scene.middle})
        out.push_back(quarter_rotations(axis, quarters, through) * best);
  return suppress_non_maxima(out, kDuplicatePose, out.size());
}

std::vector<Rigid> translated_rivals(const SurfacePair& surfaces, const Rigid& best,
                                     ThreadTeam& team) {
  const std::vector<Vector3d> axes = scene_axes(surfaces, best).axes;
  const double step = kStep * std::max(surfaces.source().leaf, surfaces.target().leaf);
  const auto steps = static_cast<int>(kFarthestTranslation / step);
  const auto nearest = static_cast<int>(kDistinctPose.translation / step);
  const std::size_t count = 2 * static_cast<std::size_t>(steps) + 1;
  const auto moved = [&](const Vector3d& axis, int k) {
    Rigid out = best;
    out.t += k * step * axis;
    return out;
  };
  std::vector<Ranking::Scratch> scratch(team.size());
  std::vector<double> scores(axes.size() * count);
  team.parallel(scores.size(), [&](std::size_t i, std::size_t thread) {
    const Rigid pose = moved(axes[i / count], static_cast<int>(i % count) - steps);
    scores[i] = surfaces.ranking().evaluate(pose, scratch[thread], SurfacePair::kQuickStep).score;
  });
  std::vector<std::pair<double, Rigid>> found;
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    const double* score = &scores[axis * count];
    const double enough = kPromising * std::max(score[steps], 0.0);
    for (int k = 1 - steps; k < steps; ++k) {
      const double here = score[k + steps];
      const bool peak = here >= score[k + steps - 1] && here > score[k + steps + 1];
      if (peak && std::abs(k) > nearest && here > enough)
        found.emplace_back(here, moved(axes[axis], k));
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Rigid> out;
  for (std::size_t i = 0; i < std::min(found.size(), kMostTranslated); ++i)
    out.push_back(found[i].second);
  return out;
}

}  // namespace emtr
