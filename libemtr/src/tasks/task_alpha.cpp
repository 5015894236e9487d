#include "task_alpha.h"

#include "transform.h"

namespace emtr {
TaskAlpha::TaskAlpha(const Densities& densities, const Settings& settings, const Kernels& kernels,
                     const MakeNeighbors& make)
    : densities_(densities),
      kernels_(kernels),
      scale_sparse_(settings.scale_sparse * densities.leaf_sparse),
      scale_dense_(settings.scale_dense * densities.leaf_dense) {
  const auto structure = [&](const Cloud& cloud, double scale, double leaf) {
    return make(cloud, static_cast<float>(scale), static_cast<float>(leaf));
  };
  target_sparse_ = structure(densities.target_sparse, scale_sparse_, densities.leaf_sparse);
  target_dense_ = structure(densities.target_dense, scale_dense_, densities.leaf_dense);
  source_dense_ = structure(densities.source_dense, scale_dense_, densities.leaf_dense);
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

double TaskAlpha::evaluate(emtr_stage stage, const Rigid& pose, Scratch& scratch) const {
  if (stage == EMTR_STAGE_SPARSE)
    return sum(densities_.source_sparse, pose, *target_sparse_, scale_sparse_, scratch);
  const double forward = sum(densities_.source_dense, pose, *target_dense_, scale_dense_, scratch);
  return forward +
         sum(densities_.target_dense, pose.inverse(), *source_dense_, scale_dense_, scratch);
}

std::size_t TaskAlpha::lookups(emtr_stage stage) const {
  if (stage == EMTR_STAGE_SPARSE) return densities_.source_sparse.size();
  return densities_.source_dense.size() + densities_.target_dense.size();
}

TaskAlpha::Residuals TaskAlpha::residuals_source(const Rigid& pose) const {
  Scratch scratch;
  const double total = sum(densities_.source_dense, pose, *target_dense_, scale_dense_, scratch);
  return {scratch.squared, total};
}

TaskAlpha::Residuals TaskAlpha::residuals_target(const Rigid& pose) const {
  Scratch scratch;
  const double total =
      sum(densities_.target_dense, pose.inverse(), *source_dense_, scale_dense_, scratch);
  return {scratch.squared, total};
}

}  // namespace emtr
