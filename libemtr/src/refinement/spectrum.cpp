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
  out.radius = std::sqrt((t[4] + t[7] + t[9]) / t[0]);
  Matrix6 H;
  sums.normal_matrix(H.data());
  H /= sums.weights;
  H.topRows<3>() /= out.radius;
  H.leftCols<3>() /= out.radius;
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
