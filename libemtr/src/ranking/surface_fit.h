#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "neighbors/neighbors.h"
#include "geometry/rigid.h"
#include "geometry/surface.h"

namespace emtr {

/// How well two surfaces lie on each other under a pose. A point is an inlier when its nearest
/// neighbor q is within 1.5 leaves, their normals are within 45 degrees (whatever their signs),
/// and it is within 0.3 leaves of q's tangent plane.
struct SurfaceFitValue {
  /// Mean of (1 - (e / 0.3 leaf)^2)^2 over all points (0 for those that are no inliers), e the
  /// distance from the tangent plane; each cloud against the other, then the mean of both. 0 to 1.
  double score = 0;
  /// What of chf is due to inliers whose normals point the same way (a positive dot product).
  double same_side = 0;
  /// Mean of the dot product of both normals, with its sign, over the inliers: near 1 or -1 where
  /// the normals of both clouds are oriented by one rule. 0 when there are no inliers.
  double sign = 0;
  double inliers_source = 0, inliers_target = 0;  ///< share of each cloud's points
  double rms = 0;                                 ///< root mean square of e / leaf over the inliers
};

/// The fine score of candidate poses: unlike a distance to points it knows which way surfaces
/// face, and unlike a coarse one it does not take one plane near another for one plane. The
/// structures are built once; any number of threads may evaluate, each with a scratch of its own.
class SurfaceFit {
 public:
  /// For each thread its own; grows at the first use and is kept.
  struct Scratch {
    std::vector<float> x, y, z, nx, ny, nz, squared;
    std::vector<std::int32_t> index;
  };

  /// The surfaces and the kernels must outlive this. Throws std::invalid_argument when the leaves
  /// are not the same positive number, or a surface lacks points or a normal for each.
  SurfaceFit(const Surface& source, const Surface& target, const Kernels& kernels);

  SurfaceFitValue evaluate(const Rigid& pose, Scratch& scratch) const;

  /// Asks every `step`-th point only, for a first pass over many poses. Step 1 asks all. The
  /// points of a step are gathered by prepare(), which must have been called for it.
  SurfaceFitValue evaluate(const Rigid& pose, std::size_t step, Scratch& scratch) const;
  void prepare(std::size_t step);
  /// Those points, of the source (0) or the target (1).
  const Cloud& points(int side, std::size_t step) const;

 private:
  /// One point with its normal in half a cache line.
  struct alignas(32) Place {
    float p[3], n[3];
  };
  struct Side {
    const Surface* surface;
    std::vector<Place> places;
    std::unique_ptr<Neighbors> neighbors;
  };
  struct Sums {
    double weight = 0, same = 0, sign = 0, squared = 0, inliers = 0;
  };
  struct Subset {
    std::size_t step;
    Cloud points[2], normals[2];
  };
  const Subset& subset(std::size_t step) const;

  static Side make_side(const Surface& surface, const Kernels& kernels);
  Sums sums(const Cloud& points, const Cloud& normals, const Rigid& pose, const Side& to,
            Scratch& scratch) const;
  SurfaceFitValue value(const Cloud* const points[2], const Cloud* const normals[2], const Rigid& pose,
                 Scratch& scratch) const;

  const Kernels& kernels_;
  float leaf_;
  Side side_[2];  // source, target
  std::vector<Subset> subsets_;
};

}  // namespace emtr
