#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "neighbors/neighbors.h"
#include "preprocessing/downsampling.h"

namespace emtr {

/// Task alpha scores a pose on the clouds. Lower is better.
///
/// S stage: sum over the sparse source points of rho(distance to the nearest target point).
/// D stage: the same over the dense source points, plus the sum over the dense target points of
/// rho(distance to the nearest source point), the M-estimator chamfer distance (MCD). Distances
/// of the second sum are measured in the source's frame: they are the same there, and one neighbor
/// structure then serves all poses. The neighbors of the D stage are points of the dense clouds, or
/// of clouds with more points: a finer fitness function by as many queries.
class TaskAlpha {
 public:
  /// Makes the neighbor structure of a cloud, with a radius, for so many queries by each evaluation
  /// of a pose at that resolution. Called by several threads at once.
  using MakeNeighbors = std::function<std::unique_ptr<Neighbors>(
      const Cloud&, float radius, std::size_t queries, emtr_resolution)>;

  /// The clouds whose points are the neighbors of the D stage, and the least c that they allow:
  /// below about two spacings of their points, points on one surface are outliers.
  struct DenseReferences {
    const Cloud &source, &target;
    double least_scale;  ///< 0: any
  };

  /// Working memory of an evaluation, one for each thread.
  struct Scratch {
    std::vector<float> x, y, z, squared;
  };

  TaskAlpha(const DownsampledClouds& downsampled, const DenseReferences& references,
            const Settings& settings, const Kernels& kernels, const MakeNeighbors& make_neighbors);

  double evaluate(emtr_resolution resolution, const Rigid& pose, Scratch& scratch) const {
    return evaluate(resolution, pose, HUGE_VAL, scratch);
  }
  /// Returns the same if it is less than `enough`, and else any number that is not: it ends early.
  double evaluate(emtr_resolution resolution, const Rigid& pose, double enough,
                  Scratch& scratch) const;

  /// Returns the number of nearest-neighbor queries of one evaluation: N_s, or N_d + M_d.
  std::size_t queries(emtr_resolution resolution) const;
  /// Returns the largest value of the fitness: that of a pose where no point has a neighbor.
  double worst(emtr_resolution resolution) const {
    return static_cast<double>(queries(resolution));
  }

  double scale(emtr_resolution resolution) const {  ///< c of the M-estimator
    return resolution == EMTR_RESOLUTION_DENSE ? scale_dense_ : scale_sparse_;
  }

  /// Squared distances at a pose, cut at c^2, and the sum of their rho: from the dense source
  /// points to the target, or from the dense target points to the source. They serve the verdict.
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
  double sum_until(double enough, const Cloud& points, const Rigid& pose,
                   const Neighbors& neighbors, double scale, Scratch& scratch) const;

  const DownsampledClouds& downsampled_;
  const Kernels& kernels_;
  double scale_sparse_, scale_dense_;
  std::unique_ptr<Neighbors> target_sparse_, target_dense_, source_dense_;
};

}  // namespace emtr
