#include "colors/channels.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <vector>

#include "util/constants.h"
#include "util/portable_log.h"

namespace emtr {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Standard deviation of a channel that hardly varies: of colors, a step of eight bits; else a
/// share of the deviation of the channel that varies most.
constexpr double kLeastDeviation = 1.0 / 255, kLeastShare = 0.05;
/// Added to an intensity, by the median, so that the noise of dark points stays small.
constexpr double kDark = 0.1;

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

double median(std::vector<float> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return static_cast<double>(*middle);
}

constexpr int kDegree = 4;
constexpr int kTerms = (kDegree + 1) * (kDegree + 2) * (kDegree + 3) / 6;

/// Returns all products of the coordinates up to the degree.
Eigen::Matrix<double, kTerms, 1> monomials(const Vector3d& p) {
  Eigen::Matrix<double, kTerms, 1> out;
  int k = 0;
  double x = 1;
  for (int i = 0; i <= kDegree; ++i, x *= p.x()) {
    double y = 1;
    for (int j = 0; i + j <= kDegree; ++j, y *= p.y()) {
      double z = 1;
      for (int l = 0; i + j + l <= kDegree; ++l, z *= p.z()) out[k++] = x * y * z;
    }
  }
  return out;
}

/// Returns the logarithms of the intensities, less their trend over the cloud.
Cloud flattened(const Cloud& points, const Cloud& intensities) {
  std::vector<float> known;
  for (const float value : intensities.x)
    if (value == value) known.push_back(value);
  Cloud out = intensities;
  const double scale = known.empty() ? 0 : median(known);
  if (!(scale > 0)) {  // no light at all
    std::fill(out.x.begin(), out.x.end(), 0.0f);
    return out;
  }
  using Terms = Eigen::Matrix<double, kTerms, 1>;
  std::vector<double> logarithm(points.size());
  Eigen::Matrix<double, kTerms, kTerms> A = Eigen::Matrix<double, kTerms, kTerms>::Zero();
  Terms b = Terms::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!has(intensities, i)) continue;
    logarithm[i] = portable_log10(static_cast<double>(intensities.x[i]) / scale + kDark);
    const Terms t = monomials(at(points, i));
    for (int k = 0; k < kTerms; ++k) A.col(k) += t * t[k];
    b += t * logarithm[i];
  }
  // A flat cloud leaves some terms open: the shortest of all solutions.
  Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix<double, kTerms, kTerms>> solver;
  solver.setThreshold(1e-9);
  const Terms trend = solver.compute(A).solve(b);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!has(intensities, i)) continue;
    const Terms t = monomials(at(points, i));
    double expected = 0;
    for (int k = 0; k < kTerms; ++k) expected += trend[k] * t[k];
    out.x[i] = static_cast<float>(logarithm[i] - expected);
  }
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

Channels make_channels(const Cloud& source_points, const Cloud& source, const Cloud& target_points,
                       const Cloud& target, ColorKind kind) {
  const bool intensities = kind == ColorKind::Intensities;
  const Cloud of_source = intensities ? flattened(source_points, source) : source,
              of_target = intensities ? flattened(target_points, target) : target;
  const Spread from = spread_of(of_source), to = spread_of(of_target);
  const Matrix3d both = from.covariance + to.covariance;
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(both);
  const Matrix3d axes = solver.eigenvectors();
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
  out.source = standardized(of_source, from, axes, out.used);
  out.target = standardized(of_target, to, axes, out.used);
  return out;
}

}  // namespace emtr
