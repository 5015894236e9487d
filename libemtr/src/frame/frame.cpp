#include "frame.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "../error.h"

namespace emtr {
namespace {

constexpr std::size_t kLeastPoints = 10;

using Points = std::vector<Eigen::Vector3d>;

template <class Scalar>
Points finite_points(const emtr_cloud& cloud, std::size_t stride) {
  Points points;
  points.reserve(cloud.count);
  const char* row = static_cast<const char*>(cloud.points);
  for (std::size_t i = 0; i < cloud.count; ++i, row += stride) {
    Scalar p[3];
    std::memcpy(p, row, sizeof p);  // the caller may not have aligned it
    if (std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]))
      points.emplace_back(p[0], p[1], p[2]);
  }
  return points;
}

Points read(const emtr_cloud& cloud, const std::string& name) {
  const bool single = cloud.scalar == EMTR_FLOAT32;
  if (!single && cloud.scalar != EMTR_FLOAT64)
    throw Error(EMTR_ERROR_ARGUMENT, name + " cloud: scalar must be EMTR_FLOAT32 or EMTR_FLOAT64");
  if (!cloud.points && cloud.count)
    throw Error(EMTR_ERROR_ARGUMENT, name + " cloud: points is null");
  const std::size_t packed = 3 * (single ? sizeof(float) : sizeof(double));
  if (cloud.stride && cloud.stride < packed)
    throw Error(EMTR_ERROR_ARGUMENT, name + " cloud: stride is " + std::to_string(cloud.stride) +
                                         " bytes, expected 0 or at least " +
                                         std::to_string(packed));
  const std::size_t stride = cloud.stride ? cloud.stride : packed;
  Points points =
      single ? finite_points<float>(cloud, stride) : finite_points<double>(cloud, stride);
  if (points.size() < kLeastPoints)
    throw Error(EMTR_ERROR_CLOUD, name + " cloud: " + std::to_string(points.size()) +
                                      " finite points of " + std::to_string(cloud.count) +
                                      ", expected at least " + std::to_string(kLeastPoints));
  return points;
}

/// Moves the centroid to the origin and returns it with the largest distance from it.
struct Extent {
  Eigen::Vector3d center;
  double radius;
};

Extent center(Points& points, const std::string& name) {
  // About the first point, so that sums of large coordinates keep their digits.
  const Eigen::Vector3d first = points.front();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& p : points) sum += p - first;
  const Eigen::Vector3d centroid = first + sum / static_cast<double>(points.size());

  double squared_radius = 0;
  for (auto& p : points) {
    p -= centroid;
    squared_radius = std::max(squared_radius, p.squaredNorm());
  }
  const double radius = std::sqrt(squared_radius);
  if (!centroid.allFinite() || !std::isfinite(radius))
    throw Error(EMTR_ERROR_CLOUD, name + " cloud: coordinates too large, expected below 1e150");
  // Rounding of large equal coordinates leaves a radius of a few units in their last place.
  if (!(radius > 1e-14 * centroid.cwiseAbs().maxCoeff()) || radius < 1e-150)
    throw Error(EMTR_ERROR_CLOUD,
                name + " cloud: all points are equal, expected a radius above 1e-150");

  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const auto& p : points) {
    const Eigen::Vector3d unit = p / radius;
    covariance += unit * unit.transpose();
  }
  const Eigen::Vector3d spread =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvalues();
  if (spread[1] <= 1e-12 * spread[2])
    throw Error(EMTR_ERROR_CLOUD, name + " cloud: all points lie on one line, expected a surface");
  return {centroid, radius};
}

Cloud scaled(const Points& points, double scale) {
  Cloud cloud;
  cloud.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    cloud.x[i] = static_cast<float>(points[i].x() / scale);
    cloud.y[i] = static_cast<float>(points[i].y() / scale);
    cloud.z[i] = static_cast<float>(points[i].z() / scale);
  }
  return cloud;
}

Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> rotation(const Rigid& pose) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(pose.R);
}

}  // namespace

NormalisedPair normalise(const emtr_cloud& source, const emtr_cloud& target) {
  Points source_points = read(source, "source");
  Points target_points = read(target, "target");
  NormalisedPair pair;
  pair.dropped_source = source.count - source_points.size();
  pair.dropped_target = target.count - target_points.size();

  const Extent s = center(source_points, "source");
  const Extent t = center(target_points, "target");
  pair.frame.scale = std::max(s.radius, t.radius);
  Eigen::Vector3d::Map(pair.frame.center_source) = s.center;
  Eigen::Vector3d::Map(pair.frame.center_target) = t.center;
  pair.source = scaled(source_points, pair.frame.scale);
  pair.target = scaled(target_points, pair.frame.scale);
  return pair;
}

Rigid Frame::to_user(const Rigid& pose) const {
  Rigid out = pose;
  Eigen::Vector3d::Map(out.t) = scale * Eigen::Vector3d::Map(pose.t) +
                                Eigen::Vector3d::Map(center_target) -
                                rotation(pose) * Eigen::Vector3d::Map(center_source);
  return out;
}

Rigid Frame::to_normalised(const Rigid& pose) const {
  Rigid out = pose;
  Eigen::Vector3d::Map(out.t) =
      (Eigen::Vector3d::Map(pose.t) + rotation(pose) * Eigen::Vector3d::Map(center_source) -
       Eigen::Vector3d::Map(center_target)) /
      scale;
  return out;
}

}  // namespace emtr
