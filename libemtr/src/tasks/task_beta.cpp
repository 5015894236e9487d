#include "task_beta.h"

#include <algorithm>
#include <cmath>

namespace emtr {
namespace {

constexpr std::size_t kLanes = 8;
constexpr std::size_t kBlock = 512;  // residuals summed in float before they go to double

struct Consensus {
  double inliers = 0, residuals = 0;
};

/// Inliers and their residuals of up to kBlock TIMs, over fixed lanes.
void add_block(const Tims& tims, const float* R, float squared_threshold, std::size_t begin,
               std::size_t end, Consensus& out) {
  const float *px = &tims.source.x[begin], *py = &tims.source.y[begin], *pz = &tims.source.z[begin];
  const float *qx = &tims.target.x[begin], *qy = &tims.target.y[begin], *qz = &tims.target.z[begin];
  const std::size_t n = end - begin;
  float count[kLanes] = {}, sum[kLanes] = {};
  const auto add = [&](std::size_t i, std::size_t l) {
    const float dx = ((R[0] * px[i] + R[1] * py[i]) + R[2] * pz[i]) - qx[i];
    const float dy = ((R[3] * px[i] + R[4] * py[i]) + R[5] * pz[i]) - qy[i];
    const float dz = ((R[6] * px[i] + R[7] * py[i]) + R[8] * pz[i]) - qz[i];
    const float squared = (dx * dx + dy * dy) + dz * dz;
    const bool inlier = squared < squared_threshold;
    count[l] += inlier ? 1.0f : 0.0f;
    sum[l] += inlier ? std::sqrt(squared) : 0.0f;
  };
  std::size_t i = 0;
  for (; i + kLanes <= n; i += kLanes)
    for (std::size_t l = 0; l < kLanes; ++l) add(i + l, l);
  for (std::size_t l = 0; i < n; ++i, ++l) add(i, l);
  for (std::size_t l = 0; l < kLanes; ++l) {
    out.inliers += static_cast<double>(count[l]);
    out.residuals += static_cast<double>(sum[l]);
  }
}

}  // namespace

TaskBeta::TaskBeta(const Tims& tims, double tau, const Settings& settings)
    : tims_(tims), penalty_(settings.outlier_penalty * tau) {
  const auto t = static_cast<float>(threshold(tau, settings));
  squared_threshold_ = t * t;
}

double TaskBeta::evaluate(const double* rotation) const {
  float R[9];
  for (int i = 0; i < 9; ++i) R[i] = static_cast<float>(rotation[i]);
  Consensus consensus;
  for (std::size_t begin = 0; begin < tims_.kept(); begin += kBlock)
    add_block(tims_, R, squared_threshold_, begin, std::min(begin + kBlock, tims_.kept()),
              consensus);
  return penalty_ * (static_cast<double>(tims_.formed()) - consensus.inliers) + consensus.residuals;
}

}  // namespace emtr
