#include "evolution/knowledge_complement.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "geometry/transform.h"
#include "tasks/m_estimator.h"
#include "util/cancellation.h"

namespace emtr {

KnowledgeComplement::KnowledgeComplement(const Cloud& source, const Cloud& target,
                                         std::unique_ptr<Neighbors> neighbors,
                                         const Settings& settings, const Kernels& kernels)
    : source_(source),
      target_(target),
      neighbors_(std::move(neighbors)),
      settings_(settings),
      kernels_(kernels) {}

Eigen::Vector3d KnowledgeComplement::translation(const Eigen::Matrix3d& R,
                                                 const Prior* prior) const {
  const std::size_t n = source_.size();
  std::vector<float> x(n), y(n), z(n), squared(n);
  std::vector<std::int32_t> index(n);
  Rigid pose;
  pose.R = R;
  if (prior) pose = prior->project(pose);

  const int iterations = settings_.complement_iterations;
  const double shrink = settings_.complement_scale_end / settings_.complement_scale_start;
  for (int k = 0; k < iterations; ++k) {
    check_cancelled();
    const double progress = iterations > 1 ? static_cast<double>(k) / (iterations - 1) : 0;
    const double scale = settings_.complement_scale_start * std::pow(shrink, progress);
    transform(kernels_, source_, pose, x.data(), y.data(), z.data());
    neighbors_->nearest({x.data(), y.data(), z.data(), n}, index.data(), squared.data());

    double weights = 0, step[3] = {};
    for (std::size_t i = 0; i < n; ++i) {
      if (index[i] < 0) continue;
      const auto j = static_cast<std::size_t>(index[i]);
      const double w = tukey_weight(static_cast<double>(squared[i]), scale * scale);
      weights += w;
      step[0] += w * (double{target_.x[j]} - double{x[i]});
      step[1] += w * (double{target_.y[j]} - double{y[i]});
      step[2] += w * (double{target_.z[j]} - double{z[i]});
    }
    if (!(weights > 0)) continue;  // nothing is near
    for (int a = 0; a < 3; ++a) pose.t[a] += step[a] / weights;
  }
  if (prior) pose = prior->project(pose);
  return pose.t;
}

std::uint64_t KnowledgeComplement::queries() const {
  return source_.size() * static_cast<std::uint64_t>(settings_.complement_iterations);
}

}  // namespace emtr
