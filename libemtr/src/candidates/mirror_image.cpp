#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "candidates/changed_source.h"
#include "candidates/quick_scores.h"
#include "candidates/scene_axes.h"

namespace emtr {
namespace {

using Eigen::Vector3d;

// Share of the pose's own quick score. A mirror a few degrees off has 0.14 to 0.2; those that lead
// nowhere stay below 0.1.
constexpr double kPromising = 0.12;

/// Returns the reflection in the plane through a point; no rotation, but a pose to the fit.
Rigid reflection(const Vector3d& normal, const Vector3d& through) {
  Rigid out;
  out.R = Eigen::Matrix3d::Identity() - 2 * normal * normal.transpose();
  out.t = 2 * normal * normal.dot(through);
  return out;
}

/// Mirrors x.
Surface mirrored(Surface surface) {
  for (float& x : surface.points.x) x = -x;
  for (float& x : surface.normals.x) x = -x;
  return surface;
}

std::optional<Viewpoint> mirrored(std::optional<Viewpoint> viewpoint) {
  if (viewpoint) viewpoint->at[0] = -viewpoint->at[0];
  return viewpoint;
}

/// Returns the reflections of the pose that fit to some degree before any refinement.
std::vector<Rigid> promising_reflections(const SurfacePair& surfaces, const Rigid& pose) {
  Ranking::Scratch scratch;
  const auto quick = [&](const Rigid& p) { return quick_score(surfaces, p, scratch); };
  const double enough = kPromising * std::max(quick(pose), 0.0);
  const SceneAxes scene = scene_axes(surfaces, pose);
  std::vector<Rigid> out;
  for (const Vector3d& axis : scene.axes)
    for (const Vector3d& through : {scene.mean, scene.middle}) {
      const Rigid reflected = reflection(axis, through) * pose;
      if (quick(reflected) > enough) out.push_back(reflected);
    }
  return out;
}

}  // namespace

double mirrored_score(const SurfacePair& surfaces, const Rigid& pose, const Kernels& kernels) {
  double best = -std::numeric_limits<double>::infinity();
  const std::vector<Rigid> reflections = promising_reflections(surfaces, pose);
  if (reflections.empty()) return best;

  const SurfacePair mirror(mirrored(surfaces.source()), surfaces.shared_target(),
                           mirrored(surfaces.source_viewpoint()), surfaces.target_viewpoint(),
                           kernels);
  Rigid flip;  // mirrors x, so that what is left of a reflection is a rotation
  flip.R(0, 0) = -1;
  Ranking::Scratch scratch;
  LocalRefinement::Scratch refinement;
  for (const Rigid& reflected : reflections) {
    const Rigid end = mirror.local_refinement()(reflected * flip, nullptr, refinement).pose;
    best = std::max(best, mirror.ranking().evaluate(end, scratch).score);
  }
  return best;
}

}  // namespace emtr
