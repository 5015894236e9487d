#include "spectrum.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace emtr {

Spectrum spectrum(const NormalEquations& sums) {
  using Matrix6 = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;
  Spectrum out;
  out.free = 6;
  if (!(sums.weights > 0)) return out;
  const double* t = sums.tangents;
  const Eigen::Vector3d center = Eigen::Vector3d::Map(t + 1) / t[0];
  Eigen::Vector3d::Map(out.center) = center;
  out.radius = std::sqrt(std::max(0.0, (t[4] + t[7] + t[9]) / t[0] - center.squaredNorm()));
  if (!(out.radius > 0)) return out;  // all on one point
  Matrix6 H;
  sums.normal_matrix(H.data());
  // J about the centre: (y - c) x n = y x n - c x n.
  Matrix6 about = Matrix6::Identity();
  about.topRightCorner<3, 3>() << 0, center.z(), -center.y(), -center.z(), 0, center.x(),
      center.y(), -center.x(), 0;
  about.topRows<3>() /= out.radius;
  H = about * H * about.transpose() / sums.weights;
  const Eigen::SelfAdjointEigenSolver<Matrix6> solver(H);
  for (int k = 0; k < 6; ++k) {
    out.values[k] = std::max(0.0, solver.eigenvalues()[k]);
    for (int i = 0; i < 6; ++i) out.directions[k][i] = solver.eigenvectors()(i, k);
  }
  out.free = static_cast<int>(
      std::count_if(out.values, out.values + 6, [](double v) { return v < kFreeDirection; }));
  return out;
}

}  // namespace emtr
