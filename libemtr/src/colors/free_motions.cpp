#include "colors/free_motions.h"

#include <Eigen/SVD>
#include <cmath>

#include "geometry/rotation_vector.h"

namespace emtr {
namespace {

using Eigen::Vector3d;

constexpr double kPureTranslation = 0.2;  // of a unit vector, what is left of it in rotations

}  // namespace

FreeMotions::FreeMotions(const HessianSpectrum& spectrum, const Rigid& pose)
    : pose_(pose), center_(Vector3d::Map(spectrum.center)) {
  const int n = spectrum.unconstrained;
  if (n == 0 || !(spectrum.radius > 0)) return;
  Eigen::MatrixXd basis(6, n);
  for (int k = 0; k < n; ++k)
    basis.col(k) = Eigen::Map<const Eigen::Matrix<double, 6, 1>>(spectrum.eigenvectors[k]);
  // Within their span, from the motion that rotates most to the one that only translates.
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(basis.topRows<3>(), Eigen::ComputeFullV);
  const Eigen::MatrixXd motions = basis * svd.matrixV();
  for (int k = n - 1; k >= 0; --k) {
    const Vector3d rotation = motions.col(k).head<3>() / spectrum.radius;
    Vector3d translation = motions.col(k).tail<3>();
    for (const Vector3d& known : translations_) translation -= known * known.dot(translation);
    const bool pure = k >= 3 || svd.singularValues()[k] < kPureTranslation;
    if (pure && translation.norm() > kPureTranslation)
      translations_.push_back(translation.normalized());
    if (!pure) rotations_.push_back({rotation.normalized(), translation / rotation.norm()});
  }
}

Rigid FreeMotions::at(const Eigen::VectorXd& x) const {
  Vector3d w = Vector3d::Zero(), v = Vector3d::Zero();
  for (std::size_t k = 0; k < rotations_.size(); ++k) {
    w += x[static_cast<Eigen::Index>(k)] * rotations_[k].rotation;
    v += x[static_cast<Eigen::Index>(k)] * rotations_[k].translation;
  }
  // The exponential of a screw, as in between().
  const double angle = w.norm();
  const Eigen::Matrix3d K = cross_matrix(w);
  const double first = angle < 1e-4 ? 0.5 : (1 - std::cos(angle)) / (angle * angle);
  const double second = angle < 1e-4 ? 1.0 / 6 : (angle - std::sin(angle)) / std::pow(angle, 3);
  Rigid motion;
  motion.R = exponential(w).toRotationMatrix();
  motion.t = center_ + (v + first * (K * v) + second * (K * (K * v))) - motion.rotate(center_);
  Rigid out = motion * pose_;
  for (std::size_t k = 0; k < translations_.size(); ++k) {
    const Vector3d& along = translations_[k];
    out.t += along * (x[static_cast<Eigen::Index>(rotations_.size() + k)] - along.dot(out.t));
  }
  return out;
}

Eigen::VectorXd FreeMotions::origin() const {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(size()));
  for (std::size_t k = 0; k < translations_.size(); ++k)
    x[static_cast<Eigen::Index>(rotations_.size() + k)] = translations_[k].dot(pose_.t);
  return x;
}

}  // namespace emtr
