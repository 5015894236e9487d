#include "refinement/information.h"

#include <algorithm>

namespace emtr {

void information(const LocalRefinementResult& refined, double design_effect, double matrix[36]) {
  const NormalEquations& s = refined.sums;
  std::fill_n(matrix, 36, 0.0);
  if (!(s.weights > 0 && s.squared_influence > 0 && s.slopes > 0)) return;
  // Covariance = A^-1 B A^-1 with A = slopes / weights * H, B = squared_influence /
  // weights * H.
  const double bend = s.slopes / s.weights, variance = s.squared_influence / s.weights;
  s.normal_matrix(matrix);
  for (int k = 0; k < 36; ++k) matrix[k] *= bend * bend / (variance * design_effect);
}

}  // namespace emtr
