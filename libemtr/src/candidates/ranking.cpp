#include "ranking.h"

namespace emtr {
namespace {

constexpr double kReach = 3;  // leaves that a polish sees at first

Polish quick_polish() {
  Polish polish;
  polish.first_scale = kReach;
  polish.last_scale = 1;
  polish.iterations = 8;
  polish.queries = 1500;
  return polish;
}

}  // namespace

Ranking::Ranking(Surface source, Surface target, const Kernels& kernels)
    : source_(std::move(source)), target_(std::move(target)), fit_(source_, target_, kernels) {
  const auto leaf = static_cast<float>(source_.leaf), reach = static_cast<float>(kReach) * leaf;
  near_source_ = make_candidate_grid(source_.points, reach, leaf, kernels);
  near_target_ = make_candidate_grid(target_.points, reach, leaf, kernels);
  polish_ = std::make_unique<LocalPolish>(source_, target_, *near_source_, *near_target_,
                                          quick_polish(), kernels);
  fit_.prepare(kQuickStep);
}

Surface surface(const Cloud& cloud, const Features& features, double leaf) {
  Surface out{cloud, {}, leaf};
  out.normals.resize(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    out.normals.x[i] = features.normals[3 * i];
    out.normals.y[i] = features.normals[3 * i + 1];
    out.normals.z[i] = features.normals[3 * i + 2];
  }
  return out;
}

}  // namespace emtr
