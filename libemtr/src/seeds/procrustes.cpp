#include "seeds/procrustes.h"

#include <Eigen/LU>
#include <Eigen/SVD>

namespace emtr {

void Procrustes::add(const Eigen::Vector3d& p, const Eigen::Vector3d& q, double weight) {
  weight_ += weight;
  p_ += weight * p;
  q_ += weight * q;
  for (int j = 0; j < 3; ++j) pq_.col(j) += weight * p * q[j];
}

Rigid Procrustes::pose() const {
  using Matrix = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  Rigid out;
  if (!(weight_ > 0)) return out;
  const Eigen::Vector3d p = p_ / weight_, q = q_ / weight_;
  const Eigen::Matrix3d covariance = pq_ / weight_ - p * q.transpose();
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
