#include "candidates/dominant_planes.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "geometry/spread_rows.h"

namespace emtr {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr std::size_t kSamples = 1024;  // points that stand for all
constexpr double kAlike = 0.95;         // cosine of normals on one plane
constexpr double kThickness = 0.02;     // radii, half of it
constexpr double kApart = 0.05;         // radii, of two parallel planes
constexpr int kRounds = 3;

struct Sample {
  Vector3d point, normal;
};

std::vector<Sample> sample(const Surface& surface) {
  std::vector<Sample> out;
  for (const std::size_t i : spread_rows(surface.points.size(), kSamples)) {
    const Cloud &p = surface.points, &n = surface.normals;
    if (std::isfinite(n.x[i])) out.push_back({{p.x[i], p.y[i], p.z[i]}, {n.x[i], n.y[i], n.z[i]}});
  }
  return out;
}

auto is_facing(const Vector3d& normal) {
  return [normal](const Sample& s) { return std::abs(s.normal.dot(normal)) > kAlike; };
}

std::vector<Sample> facing(const std::vector<Sample>& samples, const Vector3d& normal) {
  std::vector<Sample> out;
  std::copy_if(samples.begin(), samples.end(), std::back_inserter(out), is_facing(normal));
  return out;
}

/// Returns the normal that most of the others are like.
Vector3d commonest_normal(const std::vector<Sample>& samples) {
  std::size_t best = 0;
  std::ptrdiff_t most = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto count = std::count_if(samples.begin(), samples.end(), is_facing(samples[i].normal));
    if (count > most) most = count, best = i;
  }
  Vector3d normal = samples[best].normal;
  for (int round = 0; round < kRounds; ++round) {
    Matrix3d sum = Matrix3d::Zero();
    for (const Sample& s : facing(samples, normal)) sum += s.normal * s.normal.transpose();
    normal = Eigen::SelfAdjointEigenSolver<Matrix3d>(sum).eigenvectors().col(2);
  }
  return normal;
}

/// Returns the middle of the layer across the normal in which most points that face it lie.
double thickest_layer(const std::vector<Sample>& samples, const Vector3d& normal) {
  std::vector<double> offsets;
  for (const Sample& s : facing(samples, normal)) offsets.push_back(normal.dot(s.point));
  std::sort(offsets.begin(), offsets.end());
  std::size_t first = 0, best = 0, most = 0;
  for (std::size_t last = 0; last < offsets.size(); ++last) {
    while (offsets[last] - offsets[first] > 2 * kThickness) ++first;
    if (last + 1 - first > most) most = last + 1 - first, best = first;
  }
  return offsets[best + most / 2];
}

/// Fits the plane to the points near it: over a whole cloud, that is more exact than their normals.
DominantPlane fit_plane(const std::vector<Sample>& samples, const Vector3d& normal,
                        std::size_t points) {
  DominantPlane plane{normal, thickest_layer(samples, normal), 0};
  for (int round = 0; round < kRounds; ++round) {
    std::vector<Vector3d> near;
    for (const Sample& s : facing(samples, plane.normal))
      if (std::abs(plane.normal.dot(s.point) - plane.offset) < kThickness) near.push_back(s.point);
    Vector3d mean = Vector3d::Zero();
    for (const Vector3d& p : near) mean += p;
    mean /= static_cast<double>(near.size());
    Matrix3d covariance = Matrix3d::Zero();
    for (const Vector3d& p : near) covariance += (p - mean) * (p - mean).transpose();
    plane.normal = Eigen::SelfAdjointEigenSolver<Matrix3d>(covariance).eigenvectors().col(0);
    plane.offset = plane.normal.dot(mean);
    plane.share = static_cast<double>(near.size()) / static_cast<double>(points);
  }
  return plane;
}

}  // namespace

std::vector<DominantPlane> dominant_planes(const Surface& surface, std::size_t maximum_count) {
  const std::vector<Sample> all = sample(surface);
  std::vector<Sample> left = all;
  std::vector<DominantPlane> out;
  while (out.size() < maximum_count && !left.empty()) {
    const Vector3d normal = commonest_normal(left);
    DominantPlane plane = fit_plane(left, normal, all.size());
    if (plane.share < kLeastPlane) break;
    double above = 0;
    for (const Sample& s : all) above += plane.normal.dot(s.point) - plane.offset;
    if (above < 0) plane.normal = -plane.normal, plane.offset = -plane.offset;
    out.push_back(plane);
    left.erase(std::remove_if(left.begin(), left.end(),
                              [&](const Sample& s) {
                                return std::abs(s.normal.dot(plane.normal)) > kAlike &&
                                       std::abs(plane.normal.dot(s.point) - plane.offset) < kApart;
                              }),
               left.end());
  }
  return out;
}

}  // namespace emtr
