#include "seeds/procrustes.h"

#include <Eigen/Core>
#include <Eigen/LU>
#include <Eigen/SVD>

namespace emtr {

void Procrustes::add(const double p[3], const double q[3], double weight) {
  weight_ += weight;
  for (int i = 0; i < 3; ++i) {
    p_[i] += weight * p[i];
    q_[i] += weight * q[i];
    for (int j = 0; j < 3; ++j) pq_[3 * i + j] += weight * p[i] * q[j];
  }
}

Rigid Procrustes::pose() const {
  using Matrix = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  Rigid out;
  if (!(weight_ > 0)) return out;
  const Eigen::Vector3d p = Eigen::Vector3d::Map(p_) / weight_,
                        q = Eigen::Vector3d::Map(q_) / weight_;
  const Eigen::Matrix3d covariance = Eigen::Map<const Matrix>(pq_) / weight_ - p * q.transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance,
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Matrix3d &U = svd.matrixU(), &V = svd.matrixV();
  Eigen::Vector3d signs(1, 1, (V * U.transpose()).determinant() < 0 ? -1 : 1);
  const Matrix R = V * signs.asDiagonal() * U.transpose();
  out.R = R;
  out.t = q - out.rotate(p);
  return out;
}

}  // namespace emtr
