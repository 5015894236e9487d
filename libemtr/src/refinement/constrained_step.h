#pragma once

#include <Eigen/Core>

#include "priors/prior.h"

namespace emtr {

using Matrix6 = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// Returns the x that minimizes x^T H x / 2 + g^T x within the limits, by active sets: a
/// Gauss-Newton step that ends in the optimum among admissible poses, which is not the
/// unconstrained optimum moved to the border. H must be positive definite.
Vector6 constrained_step(const Matrix6& H, const Vector6& g,
                         const std::vector<Prior::Limit>& limits);

}  // namespace emtr
