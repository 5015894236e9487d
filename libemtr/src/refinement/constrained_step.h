#pragma once

#include <Eigen/Core>

#include "priors/prior.h"

namespace emtr {

using Matrix6 = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// The x with the least x^T H x / 2 + g^T x within the limits: a Gauss-Newton step that ends in the
/// optimum among admissible poses, which is not the free optimum moved to the border. By active
/// sets. H positive definite.
Vector6 constrained_step(const Matrix6& H, const Vector6& g,
                         const std::vector<Prior::Limit>& limits);

}  // namespace emtr
