#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>

#include "geometry/cloud.h"
#include "geometry/rigid.h"
#include "refinement/downsampled_surface.h"
#include "support/bumpy_pair.h"
#include "support/clouds.h"

namespace emtr_test {

/// Points on simple shapes with noise, drawn anew for each seed.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : state_(seed) {}

  double uniform(double low, double high) { return low + (high - low) * bumpy_uniform(&state_); }
  double gaussian() { return bumpy_gaussian(&state_); }
  Eigen::Vector3d direction() {
    double u[3];
    bumpy_direction(&state_, u);
    return {u[0], u[1], u[2]};
  }

  template <class Point>
  emtr::Cloud cloud(std::size_t n, double noise, Point point) {
    emtr::Cloud out;
    for (std::size_t i = 0; i < n; ++i) {
      Eigen::Vector3d p = point(*this);
      for (double& v : p) v += noise * gaussian();
      push(out, static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()));
    }
    return out;
  }

 private:
  std::uint64_t state_;
};

inline emtr::Cloud plane(std::uint64_t seed, std::size_t n, double noise) {
  return Draw(seed).cloud(n, noise, [](Draw& d) {
    return Eigen::Vector3d(d.uniform(-0.7, 0.7), d.uniform(-0.7, 0.7), 0.1);
  });
}

inline emtr::Cloud sphere(std::uint64_t seed, std::size_t n, double noise) {
  return Draw(seed).cloud(n, noise, [](Draw& d) -> Eigen::Vector3d { return 0.8 * d.direction(); });
}

inline emtr::Cloud cylinder(std::uint64_t seed, std::size_t n, double noise) {  // open at both ends
  return Draw(seed).cloud(n, noise, [](Draw& d) {
    const double angle = d.uniform(0, 2 * M_PI);
    return Eigen::Vector3d(0.4 * std::cos(angle), 0.4 * std::sin(angle), d.uniform(-0.8, 0.8));
  });
}

inline emtr::Cloud cube(std::uint64_t seed, std::size_t n, double noise) {
  return Draw(seed).cloud(n, noise, [](Draw& d) {
    Eigen::Vector3d p(d.uniform(-0.5, 0.5), d.uniform(-0.5, 0.5), d.uniform(-0.5, 0.5));
    const auto face = static_cast<int>(d.uniform(0, 6));
    p[face % 3] = face < 3 ? 0.5 : -0.5;
    return p;
  });
}

/// A small motion by its rotation vector in degrees and its translation.
inline emtr::Rigid motion(const Eigen::Vector3d& degrees, const Eigen::Vector3d& translation) {
  emtr::Rigid out;
  const double angle = degrees.norm();
  if (angle > 0) {
    const Eigen::AngleAxisd rotation(angle * M_PI / 180, degrees / angle);
    out.R = rotation.toRotationMatrix();
  }
  out.t = translation;
  return out;
}

inline double degrees_between(const emtr::Rigid& a, const emtr::Rigid& b) {
  return emtr::rotation_distance(a.R, b.R) * 180 / M_PI;
}

inline double translation_between(const emtr::Rigid& a, const emtr::Rigid& b) {
  return (a.t - b.t).norm();
}

}  // namespace emtr_test
