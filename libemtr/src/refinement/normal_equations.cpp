#include "refinement/normal_equations.h"

#include <algorithm>

namespace emtr {

NormalEquations NormalEquations::of(const double sums[kPairSums]) {
  NormalEquations out;
  const double* next = sums;
  const auto take = [&next](double* to, std::size_t count) {
    std::copy_n(next, count, to);
    next += count;
  };
  take(out.H, 21);
  take(out.g, 6);
  take(out.tangents, 10);
  for (double* one :
       {&out.weights, &out.squares, &out.squared_influence, &out.slopes, &out.inliers})
    take(one, 1);
  return out;
}

void NormalEquations::add(const NormalEquations& other) {
  for (int k = 0; k < 21; ++k) H[k] += other.H[k];
  for (int k = 0; k < 6; ++k) g[k] += other.g[k];
  for (int k = 0; k < 10; ++k) tangents[k] += other.tangents[k];
  weights += other.weights;
  squares += other.squares;
  squared_influence += other.squared_influence;
  slopes += other.slopes;
  inliers += other.inliers;
}

void NormalEquations::normal_matrix(double matrix[36]) const {
  const double* h = H;
  for (int i = 0; i < 6; ++i)
    for (int j = i; j < 6; ++j) matrix[6 * i + j] = matrix[6 * j + i] = *h++;
}

/// Adds to H, for each difference with y its place, [|y|^2 I - y y^T, [y]x; -[y]x, I].
void NormalEquations::full_matrix(double matrix[36]) const {
  normal_matrix(matrix);
  const double* y = tangents + 1;
  const double xx = tangents[4], xy = tangents[5], xz = tangents[6], yy = tangents[7],
               yz = tangents[8], zz = tangents[9];
  const double rotation[3][3] = {{yy + zz, -xy, -xz}, {-xy, xx + zz, -yz}, {-xz, -yz, xx + yy}};
  const double both[3][3] = {{0, -y[2], y[1]}, {y[2], 0, -y[0]}, {-y[1], y[0], 0}};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      matrix[6 * i + j] += rotation[i][j];
      matrix[6 * i + 3 + j] += both[i][j];
      matrix[6 * (3 + j) + i] += both[i][j];
    }
    matrix[6 * (3 + i) + 3 + i] += tangents[0];
  }
}

}  // namespace emtr
