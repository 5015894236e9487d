#include "colors/channels.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace emtr {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Standard deviation of a channel that hardly varies: of colors, a step of eight bits; else a
/// share of the deviation of the channel that varies most.
constexpr double kLeastDeviation = 1.0 / 255, kLeastShare = 0.05;

Vector3d at(const Cloud& cloud, std::size_t i) { return {cloud.x[i], cloud.y[i], cloud.z[i]}; }

bool has(const Cloud& colors, std::size_t i) { return colors.x[i] == colors.x[i]; }

/// Mean and covariance of the colors that there are.
struct Spread {
  Vector3d mean = Vector3d::Zero();
  Matrix3d covariance = Matrix3d::Zero();
};

Spread spread_of(const Cloud& colors) {
  Spread out;
  double count = 0;
  for (std::size_t i = 0; i < colors.size(); ++i) {
    if (!has(colors, i)) continue;
    out.mean += at(colors, i);
    ++count;
  }
  if (count == 0) return out;
  out.mean /= count;
  for (std::size_t i = 0; i < colors.size(); ++i) {
    if (!has(colors, i)) continue;
    const Vector3d d = at(colors, i) - out.mean;
    for (int k = 0; k < 3; ++k) out.covariance.col(k) += d * d[k];
  }
  out.covariance /= count;
  return out;
}

/// Returns the colors along the axes, of mean 0 and variance 1; 0 in a channel that is not used.
Cloud standardized(const Cloud& colors, const Spread& spread, const Matrix3d& axes,
                   const bool used[3]) {
  double scale[3];
  for (int k = 0; k < 3; ++k) {
    const Vector3d axis = axes.col(k);
    scale[k] = used[k] ? 1 / std::sqrt(axis.dot(spread.covariance * axis)) : 0;
  }
  Cloud out = colors;
  for (std::size_t i = 0; i < colors.size(); ++i) {
    if (!has(colors, i)) continue;
    const Vector3d d = at(colors, i) - spread.mean;
    float channels[3];
    for (int k = 0; k < 3; ++k)
      channels[k] = std::clamp(static_cast<float>(axes.col(k).dot(d) * scale[k]), -kFarthestColor,
                               kFarthestColor);
    out.set(i, channels);
  }
  return out;
}

}  // namespace

Channels make_channels(const Cloud& source, const Cloud& target) {
  const Spread from = spread_of(source), to = spread_of(target);
  const Matrix3d both = from.covariance + to.covariance;
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(both);
  const Matrix3d& axes = solver.eigenvectors();
  Channels out;
  const double largest = std::sqrt(std::max(0.0, solver.eigenvalues()[2] / 2));
  const double least = std::max(kLeastDeviation, kLeastShare * largest);
  for (int k = 0; k < kChannels; ++k) {
    const Vector3d axis = axes.col(k);
    const auto varies = [&](const Spread& spread) {
      return axis.dot(spread.covariance * axis) > least * least;
    };
    out.used[k] = varies(from) && varies(to);
  }
  out.source = standardized(source, from, axes, out.used);
  out.target = standardized(target, to, axes, out.used);
  return out;
}

}  // namespace emtr
