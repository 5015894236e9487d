#pragma once

#include <limits>

#include "geometry/surface.h"
#include "ranking/free_space.h"
#include "ranking/surface_fit.h"

namespace emtr {

/// Scores candidate poses for their ranking: how well the surfaces lie on each other, less how much
/// they stand where the other's sensor saw nothing.
class Ranking {
 public:
  struct Scratch {
    SurfaceFit::Scratch fit;
    FreeSpace::Scratch free_space;
  };

  struct Value {
    SurfaceFitValue fit;
    double violation = 0;
    /// fit.score - 2 violation, at most 1. With fit.same_side in the place of fit.score where the
    /// viewpoints of both are given: no sensor sees the back of what the other sees the front of.
    double score = 0;
  };

  /// A surface with viewpoints is copied, for its normals to be oriented to them; any other is
  /// shared. The kernels must outlive this. Throws as SurfaceFit does.
  Ranking(const SharedSurface& source, const SharedSurface& target,
          const Viewpoints& source_viewpoints, const Viewpoints& target_viewpoints,
          const Kernels& kernels);
  Ranking(const Ranking&) = delete;
  Ranking& operator=(const Ranking&) = delete;

  /// Leaves a pose whose fit alone does not exceed `minimum` at that: its score, which is no more
  /// than that of its fit, is then given without looking for violations.
  Value evaluate(const Rigid& pose, Scratch& scratch,
                 double minimum = -std::numeric_limits<double>::infinity()) const;

  /// Scores by every step-th point alone, for a first pass over many poses (see
  /// SurfaceFit::add_subset).
  Value quick(const Rigid& pose, std::size_t step, Scratch& scratch) const;
  SurfaceFit& fit() { return fit_; }
  const SurfaceFit& fit() const { return fit_; }

 private:
  const SharedSurface source_, target_;
  const bool both_given_;
  SurfaceFit fit_;
  FreeSpace free_space_;
};

}  // namespace emtr
