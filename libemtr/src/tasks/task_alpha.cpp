#include "tasks/task_alpha.h"

#include "geometry/transform.h"

namespace emtr {
TaskAlpha::TaskAlpha(const DownsampledClouds& downsampled, const Settings& settings,
                     const Kernels& kernels, const MakeNeighbors& make_neighbors)
    : downsampled_(downsampled),
      kernels_(kernels),
      scale_sparse_(settings.scale_sparse * downsampled.leaf_sparse),
      scale_dense_(settings.scale_dense * downsampled.leaf_dense) {
  const auto neighbors_of = [&](const Cloud& cloud, double scale, double leaf) {
    return make_neighbors(cloud, static_cast<float>(scale), static_cast<float>(leaf));
  };
  target_sparse_ = neighbors_of(downsampled.target_sparse, scale_sparse_, downsampled.leaf_sparse);
  target_dense_ = neighbors_of(downsampled.target_dense, scale_dense_, downsampled.leaf_dense);
  source_dense_ = neighbors_of(downsampled.source_dense, scale_dense_, downsampled.leaf_dense);
}

void TaskAlpha::residuals(const Cloud& points, const Rigid& pose, const Neighbors& neighbors,
                          Scratch& scratch) const {
  const std::size_t n = points.size();
  for (auto* v : {&scratch.x, &scratch.y, &scratch.z, &scratch.squared})
    if (v->size() < n) v->resize(n);
  transform(kernels_, points, pose, scratch.x.data(), scratch.y.data(), scratch.z.data());
  neighbors.squared_distances({scratch.x.data(), scratch.y.data(), scratch.z.data(), n},
                              scratch.squared.data());
}

double TaskAlpha::sum(const Cloud& points, const Rigid& pose, const Neighbors& neighbors,
                      double scale, Scratch& scratch) const {
  residuals(points, pose, neighbors, scratch);
  const auto c = static_cast<float>(scale);
  return kernels_.rho_sum(scratch.squared.data(), points.size(), 1.0f / (c * c));
}

double TaskAlpha::evaluate(emtr_resolution resolution, const Rigid& pose, Scratch& scratch) const {
  if (resolution == EMTR_RESOLUTION_SPARSE)
    return sum(downsampled_.source_sparse, pose, *target_sparse_, scale_sparse_, scratch);
  const double forward =
      sum(downsampled_.source_dense, pose, *target_dense_, scale_dense_, scratch);
  return forward +
         sum(downsampled_.target_dense, pose.inverse(), *source_dense_, scale_dense_, scratch);
}

std::size_t TaskAlpha::queries(emtr_resolution resolution) const {
  if (resolution == EMTR_RESOLUTION_SPARSE) return downsampled_.source_sparse.size();
  return downsampled_.source_dense.size() + downsampled_.target_dense.size();
}

TaskAlpha::Residuals TaskAlpha::residuals_source(const Rigid& pose) const {
  Scratch scratch;
  const double total = sum(downsampled_.source_dense, pose, *target_dense_, scale_dense_, scratch);
  return {scratch.squared, total};
}

TaskAlpha::Residuals TaskAlpha::residuals_target(const Rigid& pose) const {
  Scratch scratch;
  const double total =
      sum(downsampled_.target_dense, pose.inverse(), *source_dense_, scale_dense_, scratch);
  return {scratch.squared, total};
}

}  // namespace emtr
