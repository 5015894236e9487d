#pragma once

#include <vector>

#include "colors/color_gradients.h"
#include "priors/prior.h"
#include "refinement/fine_surfaces.h"
#include "refinement/normal_equations.h"
#include "refinement/surface_matcher.h"

namespace emtr {

struct PhotometricResult {
  Rigid pose;
  bool succeeded = false;  ///< false: too few pairs, and the pose is the one at the start
  /// At the end: the geometric residuals, as in LocalRefinementResult, and the photometric ones,
  /// of which only H counts: the sum of J J^T by the variance of their residuals.
  NormalEquations geometric, photometric;
};

/// A point of the source under a pose, and its match.
struct MovedPair {
  double y[3], v[3];  ///< the moved point, and the sum of both normals, along which `e` is measured
  double e;           ///< distance from the match along v, times the length of v
  double squared;     ///< length of v
  std::size_t source, target;  ///< rows of the surfaces
};

/// Refines a pose by the shape and the colors together (Park, Zhou and Koltun: Colored Point Cloud
/// Registration Revisited, ICCV 2017): residuals along the normals, and the difference between a
/// source point's color and the color of the target's tangent plane at the place to which the point
/// moves. Each kind counts by its own variance; gain and offset between both clouds' colors are
/// found anew in each iteration, so the exposures need not be the same. First on colors that are
/// smoothed, then as they are.
class PhotometricRefinement {
 public:
  /// `source`, `target`: channels of the fine surfaces' points. All but the channels must outlive
  /// it.
  PhotometricRefinement(const FineSurfaces& fine, const Channels& channels, const Kernels& kernels);

  /// Refines a pose. With a prior, one that admits the start, each step and the end keep to it.
  PhotometricResult operator()(const Rigid& start, const Prior* prior) const;

 private:
  struct Level {
    double radius;  ///< leaves, over which the colors are smoothed
    ColorField source, target;
  };
  std::vector<MovedPair> match(const Rigid& pose, const Level& level,
                               SurfaceMatcher::Scratch& scratch) const;
  bool iterate(const Level& level, const Prior* prior, SurfaceMatcher::Scratch& scratch,
               PhotometricResult& out) const;

  const FineSurfaces& fine_;
  const bool used_[3];
  const SurfaceMatcher matcher_;
  std::vector<Level> levels_;
};

}  // namespace emtr
