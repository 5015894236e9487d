#pragma once

#include <cstddef>
#include <random>

#include "correspondences/match_points.h"
#include "geometry/euler.h"
#include "geometry/rigid.h"

namespace emtr_test {

/// Matches between points of a cube of side 1: right ones with noise, then ones that lead anywhere.
struct Matches {
  emtr::MatchPoints points;
  emtr::Rigid pose;

  Matches(std::size_t right, std::size_t wrong, double noise, unsigned seed = 1) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal(0, 1);
    const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0 - 0.5; };
    const double particle[6] = {6 * uniform(), 3 * uniform(), 6 * uniform(), uniform(), 0.2, -0.3};
    pose = emtr::decode(particle);
    for (std::size_t i = 0; i < right + wrong; ++i) {
      const Eigen::Vector3d p(uniform(), uniform(), uniform());
      Eigen::Vector3d q(2 * uniform(), 2 * uniform(), 2 * uniform());
      if (i < right) {
        q = pose * p;
        for (int a = 0; a < 3; ++a) q[a] += noise * normal(random);
      }
      append(p, q);
    }
  }

  void append(const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
    const Eigen::Vector3f from = p.cast<float>(), to = q.cast<float>();
    points.p.append(from.x(), from.y(), from.z());
    points.q.append(to.x(), to.y(), to.z());
  }

  /// Returns the angle between a rotation and the right one, degrees.
  double error(const emtr::Rigid& found) const {
    return emtr::rotation_distance(found.R, pose.R) * 57.295779513082323;
  }
};

}  // namespace emtr_test
