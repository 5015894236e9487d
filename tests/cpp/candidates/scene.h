#pragma once

#include <algorithm>
#include <cmath>

#include "candidates/surface_pair.h"
#include "features/fpfh.h"
#include "geometry/pose_distance.h"
#include "preprocessing/downsampling.h"
#include "preprocessing/normalization.h"
#include "ranking/surfaces.h"
#include "refinement/shapes.h"
#include "settings/settings.h"

namespace emtr_test {

/// A generated pair as far as the search for candidates needs it, and the pose that is right.
struct Scene {
  Pair pair;
  emtr::Settings settings = emtr::preset("default");
  emtr::NormalizedPair normalized;
  emtr::Surface source, target;
  emtr::Rigid truth;

  explicit Scene(std::uint64_t seed, std::size_t points = 5000, double unit = 1)
      : pair(seed, points, unit), normalized(emtr::normalize(pair.source(), pair.target(), 1)) {
    settings.dense_points = 3000;
    settings.threads = 1;
    const emtr::DownsampledClouds d = emtr::downsample(normalized, settings);
    emtr::FeatureDefinition definition;
    definition.normal_radius = settings.normal_radius * d.leaf_dense;
    definition.feature_radius = settings.feature_radius * d.leaf_dense;
    definition.backend = emtr::FeatureBackend::Simd;
    const auto described = [&](const emtr::Cloud& cloud) {
      const auto features = emtr::describe(cloud, definition, emtr::select_kernels(), 1);
      return emtr::surface(cloud, features, d.leaf_dense);
    };
    source = described(d.source_dense);
    target = described(d.target_dense);
    truth = normalized.normalization.to_normalized(emtr::from_matrix(pair.pose()));
  }

  /// Where the sensors could have stood: on the axes of the scans, in each cloud's own frame and
  /// the user's unit.
  Vector sensor_source() const {
    const emtr::Rigid back = emtr::from_matrix(pair.pose()).inverse();
    return carry(back, {0.35 * 5 * pair.unit(), 0, 0.94 * 5 * pair.unit()});
  }
  Vector sensor_target() const { return {-0.35 * 5 * pair.unit(), 0, 0.94 * 5 * pair.unit()}; }

  /// The truth moved on by a rotation vector in degrees and a translation in radii.
  emtr::Rigid off(const Eigen::Vector3d& degrees, const Eigen::Vector3d& translation) const {
    return compose(motion(degrees, translation), truth);
  }

  /// Whether it is the pose that all measures of success ask for.
  bool solved(const emtr::Rigid& pose) const {
    return emtr::is_same_pose(pose, truth, {5 * M_PI / 180, 0.06});
  }
};

/// Poses all over the place.
inline std::vector<emtr::Rigid> anywhere(std::size_t n, std::uint64_t seed) {
  Draw draw(seed);
  std::vector<emtr::Rigid> out;
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector3d axis = draw.direction();  // in an order that no compiler chooses
    const double degrees = draw.uniform(0, 180);
    out.push_back(motion(degrees * axis, 0.3 * draw.direction()));
  }
  return out;
}

inline bool same_bits(const emtr::Rigid& a, const emtr::Rigid& b) {
  return a.R == b.R && a.t == b.t;
}

}  // namespace emtr_test
