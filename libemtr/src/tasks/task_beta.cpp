#include "task_beta.h"

namespace emtr {

TaskBeta::TaskBeta(const Tims& tims, double tau, const Settings& settings, const Kernels& kernels)
    : tims_(tims), kernels_(kernels), penalty_(settings.outlier_penalty * tau) {
  const auto t = static_cast<float>(threshold(tau, settings));
  squared_threshold_ = t * t;
}

double TaskBeta::evaluate(const double* rotation) const {
  float R[9];
  for (int i = 0; i < 9; ++i) R[i] = static_cast<float>(rotation[i]);
  const Consensus found =
      kernels_.consensus(tims_.source.view(), tims_.target.view(), R, squared_threshold_);
  return penalty_ * (static_cast<double>(tims_.formed()) - found.inliers) + found.residuals;
}

}  // namespace emtr
