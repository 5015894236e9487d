#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "preprocessing/downsampling.h"
#include "neighbors/neighbors.h"

namespace emtr {

/// Task alpha: a pose, scored on the clouds. Lower is better.
///
/// S stage: sum over the sparse source points of rho(distance to the nearest target point).
/// D stage: the same over the dense source points, plus the sum over the dense target points of
/// rho(distance to the nearest source point), the M-estimator chamfer distance (MCD). Distances
/// of the second sum are taken in the source's frame, which is the same and needs one structure.
class TaskAlpha {
 public:
  /// How to make a neighbor structure of a cloud, with a radius and a leaf.
  using MakeNeighbors =
      std::function<std::unique_ptr<Neighbors>(const Cloud&, float radius, float leaf)>;

  /// Memory that an evaluation works in; one a thread.
  struct Scratch {
    std::vector<float> x, y, z, squared;
  };

  TaskAlpha(const DownsampledClouds& downsampled, const Settings& settings, const Kernels& kernels,
            const MakeNeighbors& make);

  double evaluate(emtr_stage stage, const Rigid& pose, Scratch& scratch) const;

  /// Look-ups that one evaluation makes: N_s, or N_d + M_d.
  std::size_t queries(emtr_stage stage) const;
  /// The largest value that the fitness can take: every point without a neighbor.
  double worst(emtr_stage stage) const { return static_cast<double>(queries(stage)); }

  double scale(emtr_stage stage) const {  ///< c of the M-estimator
    return stage == EMTR_STAGE_DENSE ? scale_dense_ : scale_sparse_;
  }

  /// Squared distances at a pose, cut at c^2, and the sum of their rho: of the dense source points
  /// to the target, of the dense target points to the source. For the verdict.
  struct Residuals {
    std::vector<float> squared;
    double rho_sum;
  };
  Residuals residuals_source(const Rigid& pose) const;
  Residuals residuals_target(const Rigid& pose) const;

 private:
  void residuals(const Cloud& points, const Rigid& pose, const Neighbors& neighbors,
                 Scratch& scratch) const;
  double sum(const Cloud& points, const Rigid& pose, const Neighbors& neighbors, double scale,
             Scratch& scratch) const;

  const DownsampledClouds& downsampled_;
  const Kernels& kernels_;
  double scale_sparse_, scale_dense_;
  std::unique_ptr<Neighbors> target_sparse_, target_dense_, source_dense_;
};

}  // namespace emtr
