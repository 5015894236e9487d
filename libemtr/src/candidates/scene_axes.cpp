#include "candidates/scene_axes.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace emtr {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kParallel = 0.98;  // of the cosine of two axes

Vector3d row(const Cloud& cloud, std::size_t i) {
  return {double{cloud.x[i]}, double{cloud.y[i]}, double{cloud.z[i]}};
}

std::vector<Vector3d> laid_together(const SurfacePair& surfaces, const Rigid& pose) {
  const Cloud &source = surfaces.source().points, &target = surfaces.target().points;
  std::vector<Vector3d> out;
  out.reserve(source.size() + target.size());
  for (std::size_t i = 0; i < source.size(); ++i) out.push_back(pose * row(source, i));
  for (std::size_t i = 0; i < target.size(); ++i) out.push_back(row(target, i));
  return out;
}

}  // namespace

SceneAxes scene_axes(const SurfacePair& surfaces, const Rigid& pose) {
  const std::vector<Vector3d> points = laid_together(surfaces, pose);
  SceneAxes out;
  out.mean = Vector3d::Zero();
  for (const Vector3d& p : points) out.mean += p;
  out.mean /= static_cast<double>(points.size());
  Matrix3d covariance = Matrix3d::Zero();
  for (const Vector3d& p : points) covariance += (p - out.mean) * (p - out.mean).transpose();
  const Matrix3d principal = Eigen::SelfAdjointEigenSolver<Matrix3d>(covariance).eigenvectors();

  Vector3d low = Vector3d::Constant(HUGE_VAL), high = -low;
  for (const Vector3d& p : points) {
    const Vector3d along = principal.transpose() * p;
    low = low.cwiseMin(along);
    high = high.cwiseMax(along);
  }
  out.middle = principal * (low + high) / 2;
  out.axes = {principal.col(0), principal.col(1), principal.col(2)};
  const std::size_t plainest = surfaces.ranking().fit().plainest_of_target();
  const Vector3d dominant =
      row(surfaces.target().normals, plainest).normalized();  // floats are not quite
  const bool known = std::any_of(out.axes.begin(), out.axes.end(), [&](const Vector3d& axis) {
    return !(std::abs(axis.dot(dominant)) < kParallel);  // or there is none
  });
  if (!known) out.axes.push_back(dominant);
  return out;
}

}  // namespace emtr
