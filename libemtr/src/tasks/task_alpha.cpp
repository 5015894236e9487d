#include "tasks/task_alpha.h"

#include <algorithm>

#include "geometry/transform.h"
#include "kernels/search_kernels.h"
#include "util/thread_team.h"

namespace emtr {
namespace {

constexpr std::size_t kPiece = 512;  // points between two looks at the sum; a multiple of kLanes

}  // namespace

TaskAlpha::TaskAlpha(const DownsampledClouds& downsampled, const DenseReferences& references,
                     const Settings& settings, const Kernels& kernels,
                     const MakeNeighbors& make_neighbors)
    : downsampled_(downsampled),
      kernels_(kernels),
      scale_sparse_(settings.scale_sparse * downsampled.leaf_sparse),
      scale_dense_(
          std::max(settings.scale_dense * downsampled.leaf_dense, references.least_scale)) {
  const auto scale_sparse = static_cast<float>(scale_sparse_),
             scale_dense = static_cast<float>(scale_dense_);
  parallel_for(3, thread_count(settings), [&](std::size_t i) {
    if (i == 0)
      target_dense_ = make_neighbors(references.target, scale_dense,
                                     downsampled.source_dense.size(), EMTR_RESOLUTION_DENSE);
    else if (i == 1)
      source_dense_ = make_neighbors(references.source, scale_dense,
                                     downsampled.target_dense.size(), EMTR_RESOLUTION_DENSE);
    else
      target_sparse_ = make_neighbors(downsampled.target_sparse, scale_sparse,
                                      downsampled.source_sparse.size(), EMTR_RESOLUTION_SPARSE);
  });
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

/// Sums up piece by piece. No term is negative, and rounding keeps the order of sums, so that what
/// is not less than `enough` by then never will be.
double TaskAlpha::sum_until(double enough, const Cloud& points, const Rigid& pose,
                            const Neighbors& neighbors, double scale, Scratch& scratch) const {
  for (auto* v : {&scratch.x, &scratch.y, &scratch.z, &scratch.squared})
    if (v->size() < kPiece) v->resize(kPiece);
  const auto c = static_cast<float>(scale);
  const float inverse = 1.0f / (c * c);
  double lanes[kLanes] = {}, total = 0;
  for (std::size_t first = 0; first < points.size() && total < enough; first += kPiece) {
    PointsView piece = points.view();
    piece.x += first, piece.y += first, piece.z += first;
    piece.size = std::min(kPiece, piece.size - first);
    transform(kernels_, piece, pose, scratch.x.data(), scratch.y.data(), scratch.z.data());
    neighbors.squared_distances({scratch.x.data(), scratch.y.data(), scratch.z.data(), piece.size},
                                scratch.squared.data());
    search_kernels(kernels_).add_rho(scratch.squared.data(), piece.size, inverse, lanes);
    total = total_of_lanes(lanes);
  }
  return total;
}

double TaskAlpha::evaluate(emtr_resolution resolution, const Rigid& pose, double enough,
                           Scratch& scratch) const {
  if (resolution == EMTR_RESOLUTION_SPARSE)
    return sum_until(enough, downsampled_.source_sparse, pose, *target_sparse_, scale_sparse_,
                     scratch);
  const double forward =
      sum_until(enough, downsampled_.source_dense, pose, *target_dense_, scale_dense_, scratch);
  if (!(forward < enough)) return forward;
  // What forward + backward < enough needs of the backward sum, and a little more for rounding.
  const double left = (enough - forward) * (1 + 1e-12) + 1e-12 * enough;
  return forward + sum_until(left, downsampled_.target_dense, pose.inverse(), *source_dense_,
                             scale_dense_, scratch);
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
