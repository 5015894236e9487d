#include "pipeline/scene_parts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "candidates/places.h"
#include "kernels/kernels.h"
#include "preprocessing/cloud_reader.h"
#include "util/cancellation.h"

namespace emtr {
namespace {

constexpr std::size_t kPosesOfPart = 20;
constexpr double kPartRadius = 1.25;  // of the small cloud's
constexpr double kSamePart = 0.7;     // of the small cloud's radius, between two centers

}  // namespace

Scene::Scene(const InputCloud& small, const InputCloud& large)
    : preprocessed_small_(*small.preprocessed), preprocessed_large_(*large.preprocessed) {
  small_ = scale_cloud(preprocessed_small_.base, small_radius());
  large_ = preprocessed_large_.finest();
  if (!large.cloud || large_.size() == preprocessed_large_.count - preprocessed_large_.strays)
    return;
  large_ = {};
  const CloudReader reader(*large.cloud, "cloud");
  for (std::size_t block = 0; block < reader.blocks(); ++block) {
    check_cancelled();
    reader.each_finite(block, [&](std::size_t, const double* p) { append(p); });
  }
}

/// Appends as read_all_points() does, to the same bits; strays are outside of the unit ball.
void Scene::append(const double* p) {
  const double inverse = 1 / preprocessed_large_.radius;
  double q[3];
  for (std::size_t a = 0; a < 3; ++a) q[a] = (p[a] - preprocessed_large_.center[a]) * inverse;
  if (std::hypot(q[0], q[1], q[2]) <= 1)
    large_.append(static_cast<float>(q[0]), static_cast<float>(q[1]), static_cast<float>(q[2]));
}

double Scene::small_radius() const {
  return preprocessed_small_.radius / preprocessed_large_.radius;
}

Rigid Scene::to_user(const Rigid& pose) const {
  Normalization n;
  n.scale = preprocessed_large_.radius;
  std::copy_n(preprocessed_small_.center, 3, n.center_source);
  std::copy_n(preprocessed_large_.center, 3, n.center_target);
  return n.to_user(pose);
}

std::vector<double> Scene::points_about(const Eigen::Vector3d& center) const {
  const double radius = kPartRadius * small_radius();
  std::vector<double> out;
  for (std::size_t i = 0; i < large_.size(); ++i) {
    const double p[3] = {double{large_.x[i]}, double{large_.y[i]}, double{large_.z[i]}};
    if (std::hypot(p[0] - center.x(), p[1] - center.y(), p[2] - center.z()) > radius) continue;
    for (std::size_t a = 0; a < 3; ++a)
      out.push_back(preprocessed_large_.center[a] + preprocessed_large_.radius * p[a]);
  }
  return out;
}

ScenePart Scene::part_at(const Rigid& pose) const {
  const Eigen::Vector3d center = pose * Eigen::Vector3d::Map(preprocessed_small_.center);
  const Eigen::Vector3d from_middle = center - Eigen::Vector3d::Map(preprocessed_large_.center);
  return {points_about(from_middle / preprocessed_large_.radius), {pose}};
}

std::vector<ScenePart> Scene::find_parts(const Settings& settings) const {
  std::vector<ScenePart> out;
  std::vector<Eigen::Vector3d> centers;
  for (const Rigid& pose : find_places(small_, large_, settings, select_kernels())) {
    const auto same = std::find_if(centers.begin(), centers.end(), [&](const auto& center) {
      return (center - pose.t).norm() < kSamePart * small_radius();
    });
    const auto index = static_cast<std::size_t>(same - centers.begin());
    if (same == centers.end()) {
      if (out.size() == static_cast<std::size_t>(settings.parts)) continue;
      centers.push_back(pose.t);
      out.push_back({points_about(pose.t), {}});
    }
    if (out[index].poses.size() < kPosesOfPart) out[index].poses.push_back(to_user(pose));
  }
  return out;
}

}  // namespace emtr
