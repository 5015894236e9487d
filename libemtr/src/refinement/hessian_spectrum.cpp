#include "refinement/hessian_spectrum.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "geometry/rotation_vector.h"

namespace emtr {

HessianSpectrum hessian_spectrum(const NormalEquations& sums) {
  using Matrix6 = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;
  HessianSpectrum out;
  out.unconstrained = 6;
  if (!(sums.weights > 0)) return out;
  const double* t = sums.tangents;
  const Eigen::Vector3d center = Eigen::Vector3d::Map(t + 1) / t[0];
  Eigen::Vector3d::Map(out.center) = center;
  out.radius = std::sqrt(std::max(0.0, (t[4] + t[7] + t[9]) / t[0] - center.squaredNorm()));
  if (!(out.radius > 0)) return out;  // all on one point
  Matrix6 H;
  sums.normal_matrix(H.data());
  // J about the center: (y - c) x n = y x n - c x n.
  Matrix6 about = Matrix6::Identity();
  about.topRightCorner<3, 3>() << 0, center.z(), -center.y(), -center.z(), 0, center.x(),
      center.y(), -center.x(), 0;
  about.topRows<3>() /= out.radius;
  H = about * H * about.transpose() / sums.weights;
  const Eigen::SelfAdjointEigenSolver<Matrix6> solver(H);
  for (int k = 0; k < 6; ++k) {
    out.eigenvalues[k] = std::max(0.0, solver.eigenvalues()[k]);
    for (int i = 0; i < 6; ++i) out.eigenvectors[k][i] = solver.eigenvectors()(i, k);
  }
  out.unconstrained = static_cast<int>(std::count_if(
      out.eigenvalues, out.eigenvalues + 6, [](double v) { return v < kUnconstrainedEigenvalue; }));
  return out;
}

int unconstrained_within(const HessianSpectrum& spectrum, const std::vector<Prior::Limit>& limits) {
  using Matrix = Eigen::MatrixXd;
  if (!(spectrum.radius > 0)) return spectrum.unconstrained;
  // Converts a motion (rotation times radius, translation of the center) into the rotation vector
  // and the translation at the origin.
  const Eigen::Vector3d c = Eigen::Vector3d::Map(spectrum.center) / spectrum.radius;
  Matrix motion = Matrix::Identity(6, 6);
  motion.topLeftCorner<3, 3>() /= spectrum.radius;
  motion.bottomLeftCorner<3, 3>() = cross_matrix(c);
  Matrix fixed(0, 6);
  for (const Prior::Limit& limit : limits) {
    if (!limit.equality) continue;
    fixed.conservativeResize(fixed.rows() + 1, 6);
    fixed.bottomRows<1>() = Eigen::Map<const Eigen::RowVectorXd>(limit.J, 6) * motion;
  }
  if (fixed.rows() == 0) return spectrum.unconstrained;
  const Eigen::JacobiSVD<Matrix> svd(fixed, Eigen::ComputeFullV);
  const Matrix admitted = svd.matrixV().rightCols(6 - svd.rank());
  Matrix H = Matrix::Zero(6, 6);
  for (int k = 0; k < 6; ++k) {
    const auto direction = Eigen::Map<const Eigen::VectorXd>(spectrum.eigenvectors[k], 6);
    H += spectrum.eigenvalues[k] * direction * direction.transpose();
  }
  if (admitted.cols() == 0) return 0;
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(admitted.transpose() * H * admitted);
  return static_cast<int>((solver.eigenvalues().array() < kUnconstrainedEigenvalue).count());
}

}  // namespace emtr
