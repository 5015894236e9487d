#pragma once

#include "geometry/rigid.h"
#include "refinement/fine_surfaces.h"

namespace emtr {

/// How much of each cloud lies on the other under a pose, and how closely. Up to 5000 of each
/// cloud's base points are looked at, evenly over their rows; one has a correspondence when the
/// nearest point of the other's fine surface is within one leaf of it.
struct Overlap {
  double overlap_source = 0, overlap_target = 0;  ///< share that has a correspondence
  /// Root mean squares over the source's points with a correspondence, in the normalized frame: of
  /// the distance to it, and of the distance to its tangent plane. NaN where there are none.
  double rmse = 0, plane_rmse = 0;
  double flatness = 0;  ///< plane_rmse / rmse, mean of both directions; NaN when one has none
};

Overlap evaluate_overlap(const NormalizedPair& pair, const FineSurfaces& fine, const Rigid& pose,
                         const Kernels& kernels, int threads = 1);

/// Measures how the surfaces lie to each other: 0, as flush as each cloud lies on its own surface;
/// 1, as if they crossed at random within the leaf. NaN when the overlap has no flatness.
double surface_mismatch(const Overlap& overlap, const NormalizedPair& pair,
                        const FineSurfaces& fine, const Kernels& kernels, int threads = 1);

}  // namespace emtr
