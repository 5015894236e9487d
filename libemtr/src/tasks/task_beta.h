#pragma once

#include <Eigen/Core>

#include "correspondences/tims.h"
#include "settings/settings.h"

namespace emtr {

/// Task beta scores a rotation on TIMs by the modified consensus. Lower is better:
/// f = eta * #outliers + sum over inliers |q - R p|, inlier when |q - R p| < threshold.
class TaskBeta {
 public:
  /// Takes `tau` in the normalized frame.
  TaskBeta(const Tims& tims, double tau, const Settings& settings, const Kernels& kernels);

  double evaluate(const Eigen::Matrix3d& rotation) const;

  bool informative() const { return tims_.size() > 0; }

  static double threshold(double tau, const Settings& settings) {
    return settings.inlier_threshold * tau;
  }

 private:
  const Tims& tims_;
  const Kernels& kernels_;
  Cloud source_, target_;  ///< the correspondences in an order that keeps neighbors together
  float squared_threshold_;
  double penalty_;  ///< eta
};

}  // namespace emtr
