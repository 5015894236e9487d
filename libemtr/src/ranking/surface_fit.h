#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/similarity.h"
#include "geometry/surface.h"
#include "neighbors/neighbors.h"

namespace emtr {

/// How well two surfaces lie on each other under a pose. A point is an inlier when its nearest
/// neighbor q is within 1.5 leaves, their normals are within 45 degrees (whatever their signs),
/// and it is within 0.3 leaves of q's tangent plane.
struct SurfaceFitValue {
  /// The surface-fit score: the mean of (1 - (e / 0.3 leaf)^2)^2 over all points (0 for those that
  /// are no inliers), weighted by their distinctiveness(), e the distance from the tangent plane;
  /// each cloud against the other, then the mean of both. 0 to 1.
  double score = 0;
  /// The weighted share of the points whose nearest neighbor is near enough, on its plane or not:
  /// no less than the score.
  double near = 0;
  /// The part of the score due to inliers whose normals point the same way (a positive dot
  /// product).
  double same_side = 0;
  /// Mean of the dot product of both normals, with its sign, over the inliers: near 1 or -1 where
  /// the normals of both clouds are oriented by one rule. 0 when there are no inliers.
  double sign = 0;
  double inliers_source = 0, inliers_target = 0;  ///< share of each cloud's points
  /// Share of all points that are the same in both clouds, to a hundredth of a leaf.
  double same_points = 0;
  double rms = 0;                             ///< root mean square of e / leaf over the inliers
  double score_source = 0, score_target = 0;  ///< of each cloud against the other
};

/// Scores candidate poses: unlike a distance to points it knows which way surfaces face, and unlike
/// a coarse one it does not take one plane near another for one plane. The structures are built
/// once; any number of threads may evaluate, each with a scratch of its own.
class SurfaceFit {
 public:
  /// Working memory, one for each thread; grows at the first use and is kept.
  struct Scratch {
    std::vector<float> x, y, z, nx, ny, nz, squared;
    std::vector<std::int32_t> index;
    std::vector<std::uint8_t> inlier[2];  ///< of the last pose: the source's points, the target's
  };

  /// The kernels must outlive this. Throws std::invalid_argument when the leaves are not the same
  /// positive number, or a surface lacks points or a normal for each.
  SurfaceFit(const SharedSurface& source, const SharedSurface& target, const Kernels& kernels);

  /// Makes what a fit looks for in the memory of a surface. Throws std::invalid_argument as above.
  static void make_ahead(const SharedSurface& surface, const Kernels& kernels);

  SurfaceFitValue evaluate(const Rigid& pose, Scratch& scratch) const {
    return evaluate(pose, 1, scratch);
  }

  /// Evaluates every `step`-th point only, for a first pass over many poses. Throws
  /// std::invalid_argument when add_subset() was not called for a step above 1.
  SurfaceFitValue evaluate(const Rigid& pose, std::size_t step, Scratch& scratch) const;

  /// Evaluates a similarity near a rigid pose: the source's own distances are taken in its unit.
  SurfaceFitValue evaluate(const Similarity& similarity, std::size_t step, Scratch& scratch) const;

  /// Gathers every `step`-th point of both surfaces.
  void add_subset(std::size_t step);
  /// Returns the row of the target's point whose normal most others share.
  std::size_t plainest_of_target() const { return plainest_of_target_; }
  /// Returns the points of that subset, of the source (0) or the target (1).
  const Cloud& points(int side, std::size_t step) const;

 private:
  /// Points with their weights, of which the sum is 1.
  struct Weighted {
    SharedSurface surface;
    std::vector<float> weights;
  };
  struct Sums {
    double weight = 0, same_side = 0, near = 0, sign = 0, squared = 0, inliers = 0, same_points = 0;
  };
  /// Every step-th point of the source and of the target.
  struct Subset {
    std::size_t step;
    Weighted side[2];
  };
  const Subset& subset(std::size_t step) const;

  static Weighted weighted(const SharedSurface& surface, std::vector<float> weights);
  Sums sums(const Weighted& from, const Similarity& similarity, int to, Scratch& scratch) const;

  const Kernels& kernels_;
  const float leaf_;
  std::size_t plainest_of_target_ = 0;
  const SharedNeighbors neighbors_[2];  // of the source, of the target
  std::vector<Subset> subsets_;         // all points first
};

}  // namespace emtr
