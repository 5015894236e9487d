#include "colors/fall_off.h"

#include <Eigen/Core>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <vector>

#include "colors/color_gradients.h"
#include "util/portable_log.h"

namespace emtr {
namespace {

using Eigen::Vector3d;

/// Added to an intensity, by the median, so that the noise of dark points stays small.
constexpr double kDark = 0.1;
/// Over which what the polynomial has left is taken out: radii.
constexpr double kReach = 0.15;

Vector3d at(const Cloud& cloud, std::size_t i) { return {cloud.x[i], cloud.y[i], cloud.z[i]}; }

bool has(const Cloud& intensities, std::size_t i) { return intensities.x[i] == intensities.x[i]; }

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

/// Returns the logarithms of the intensities, less a polynomial in the coordinates.
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

}  // namespace

Cloud without_fall_off(const Surface& surface, const Cloud& intensities) {
  Cloud out = flattened(surface.points, intensities);
  const bool first[] = {true, false, false};
  const ColorField trend = fit_color_field(surface, out, first, kReach, false);
  for (std::size_t i = 0; i < out.size(); ++i) out.x[i] -= trend.values.x[i];
  return out;
}

}  // namespace emtr
