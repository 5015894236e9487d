#pragma once

#include <Eigen/Core>

#include "geometry/similarity.h"
#include "kernels/kernels.h"
#include "neighbors/neighbors.h"
#include "priors/prior.h"
#include "refinement/local_refinement_settings.h"
#include "refinement/surface_matcher.h"

namespace emtr {

using Matrix7 = Eigen::Matrix<double, 7, 7, Eigen::RowMajor>;
using Vector7 = Eigen::Matrix<double, 7, 1>;

/// Sums over the matched pairs of one similarity. The small change x that they refer to is that of
/// moved(): a rotation vector and a translation on the left in the target's frame about its origin,
/// then the logarithm of the scale, about where the source's origin ends.
struct SimilarityEquations {
  Matrix7 H = Matrix7::Zero();  ///< sum of w J J^T over the residuals e along the pairs' normals
  Vector7 g = Vector7::Zero();  ///< sum of w e J
  Eigen::Vector3d moments = Eigen::Vector3d::Zero();  ///< sum of w y
  double second_moment = 0;                           ///< sum of w |y|^2
  double weights = 0;                                 ///< sum of w
  double squared_influence = 0;                       ///< sum of (w e)^2
  double slopes = 0;                                  ///< sum of d(w e)/de
  std::size_t inliers = 0;                            ///< pairs with a weight above zero
};

/// The scale's share in how well the matched surfaces constrain a similarity: the Schur complement
/// of the Hessian per weight, H_ss - H_sr H_rr^+ H_rs, with lengths in root mean square radii of
/// the matches. It is what the change of scale moves along the normals after the best rigid motion
/// has made up for it: 1 for a sphere, 0.5 for a room, 0.08 for trees on a ground, and 0 for a
/// plane, a wedge, a cone or a corner of three planes, which are similar to themselves.
constexpr double kUnconstrainedScale = 3e-3;

struct SimilarityFit {
  Similarity similarity;
  bool succeeded = false;       ///< false: too few inliers, and the similarity is the start
  double scale_constraint = 0;  ///< see kUnconstrainedScale: below it the scale is unconstrained
  SimilarityEquations sums;     ///< at the last iteration
};

/// Refines similarities of one pair of surfaces: symmetric point to plane along the mean of the two
/// normals, from both sides, with annealed Tukey weights, by Gauss-Newton over seven directions.
/// Directions that the surfaces leave unconstrained are left out of each step: a plane that may
/// shrink would. From both sides, since a cloud that shrinks into a point lies well on any surface.
class SimilarityRefinement {
 public:
  /// Neighbors as LocalRefinement needs them, of both surfaces. They and the kernels must outlive
  /// it.
  SimilarityRefinement(const SharedSurface& source, const SharedSurface& target,
                       const Neighbors& near_source, const Neighbors& near_target,
                       const LocalRefinementSettings& settings, const Kernels& kernels);

  /// `prior`: admits the start, and the end too; or null.
  SimilarityFit operator()(const Similarity& start, const Prior* prior) const;

 private:
  SimilarityEquations sum_up(const Similarity& at, double cut_off, bool all_queries,
                             SurfaceMatcher::Scratch& scratch) const;

  const LocalRefinementSettings settings_;
  const double leaf_;
  const SurfaceMatcher matcher_;
};

}  // namespace emtr
