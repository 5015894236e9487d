#include "tasks/task_beta.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "geometry/transform.h"

namespace emtr {
namespace {

using Rows = std::vector<std::size_t>;

/// Orders the rows so that whole blocks lie close together in both clouds: halves them across the
/// longest side of their box, recursively.
void cluster(const std::vector<const std::vector<float>*>& axes, Rows::iterator begin,
             Rows::iterator end) {
  constexpr std::ptrdiff_t block = 16;
  if (end - begin <= block) return;
  const std::vector<float>* longest = nullptr;
  float length = -1;
  for (const auto* axis : axes) {
    const auto less = [axis](std::size_t a, std::size_t b) { return (*axis)[a] < (*axis)[b]; };
    const auto [low, high] = std::minmax_element(begin, end, less);
    if ((*axis)[*high] - (*axis)[*low] <= length) continue;
    length = (*axis)[*high] - (*axis)[*low];
    longest = axis;
  }
  const auto middle = begin + ((end - begin) / 2 + block - 1) / block * block;
  std::nth_element(begin, middle, end, [longest](std::size_t a, std::size_t b) {
    return std::make_pair((*longest)[a], a) < std::make_pair((*longest)[b], b);
  });
  cluster(axes, begin, middle);
  cluster(axes, middle, end);
}

}  // namespace

TaskBeta::TaskBeta(const Tims& tims, double tau, const Settings& settings, const Kernels& kernels)
    : tims_(tims), kernels_(kernels), penalty_(settings.outlier_penalty * tau) {
  const auto t = static_cast<float>(threshold(tau, settings));
  squared_threshold_ = t * t;
  const Cloud &p = tims.ends_source, &q = tims.ends_target;
  Rows rows(p.size());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  cluster({&p.x, &p.y, &p.z, &q.x, &q.y, &q.z}, rows.begin(), rows.end());
  source_ = p.select(rows);
  target_ = q.select(rows);
}

double TaskBeta::evaluate(const Eigen::Matrix3d& rotation) const {
  const RotationFloats R(rotation);
  std::vector<float> room(consensus_room(source_.size()));
  const Consensus found =
      kernels_.consensus(source_.view(), target_.view(), R.values, squared_threshold_, room.data());
  return penalty_ * (static_cast<double>(tims_.formed()) - found.inliers) + found.residuals;
}

}  // namespace emtr
