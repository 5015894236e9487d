#pragma once

#include <cstddef>

#include "kernels/search_kernels.h"

namespace emtr {

/// Sums over the matched pairs of one pose. The small motion x that they refer to is a rotation
/// vector (radians) and then a translation, both on the left in the target's frame about its
/// origin: y <- exp(x[0..2]) y + x[3..5]. Symmetric matrices are kept as the rows of their upper
/// triangle.
struct NormalEquations {
  double H[21] = {};             ///< sum of w J J^T over the residuals e along the pairs' normals
  double g[6] = {};              ///< sum of w e J, and of the other differences' share in it
  double tangents[10] = {};      ///< of the weak pull in all directions: sums of w, w y, w y y^T
  double weights = 0;            ///< sum of w
  double squares = 0;            ///< sum of w e^2
  double squared_influence = 0;  ///< sum of (w e)^2
  double slopes = 0;   ///< sum of d(w e)/de, what is left of w where the M-estimator bends
  double inliers = 0;  ///< how many pairs have a weight above zero

  /// Returns the sums that are in an array in the order of the fields.
  static NormalEquations of(const double sums[kPairSums]);

  /// Adds a residual e with its derivative J and weight w.
  void add_normal(const double J[6], double e, double w) {
    double* h = H;
    for (int i = 0; i < 6; ++i) {
      const double wJ = w * J[i];
      g[i] += wJ * e;
      for (int j = i; j < 6; ++j) *h++ += wJ * J[j];
    }
  }

  /// Adds the difference d of the moved point y from its match, in all three directions.
  void add_difference(const double y[3], const double d[3], double w) {
    const double wy[3] = {w * y[0], w * y[1], w * y[2]}, wd[3] = {w * d[0], w * d[1], w * d[2]};
    tangents[0] += w;
    double* yy = tangents + 4;
    for (int i = 0; i < 3; ++i) {
      tangents[1 + i] += wy[i];
      for (int j = i; j < 3; ++j) *yy++ += wy[i] * y[j];
      g[3 + i] += wd[i];
    }
    g[0] += y[1] * wd[2] - y[2] * wd[1];
    g[1] += y[2] * wd[0] - y[0] * wd[2];
    g[2] += y[0] * wd[1] - y[1] * wd[0];
  }

  void add(const NormalEquations& other);

  /// Writes the matrix of all the terms: H and what the differences add to it, row-major 6x6.
  void full_matrix(double matrix[36]) const;

  /// Writes H alone: what the shape of the surface constrains.
  void normal_matrix(double matrix[36]) const;
};

}  // namespace emtr
