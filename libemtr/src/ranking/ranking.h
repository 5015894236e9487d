#pragma once

#include <optional>

#include "geometry/surface.h"
#include "ranking/free_space.h"
#include "ranking/surface_fit.h"

namespace emtr {

/// Scores candidate poses for their ranking: how well the surfaces lie on each other where that
/// means something, less what lies near the other surface but not on it, less what stands where the
/// other's sensor saw nothing.
class Ranking {
 public:
  struct Scratch {
    SurfaceFit::Scratch fit;
    FreeSpace::Scratch free_space;
  };

  struct Value {
    SurfaceFitValue fit;
    double violation = 0;
    /// fit.score - 0.1 (fit.near - fit.score) - violation, at most 1. With fit.same_side in the
    /// place of fit.score where the user gave both viewpoints: no sensor sees the back of what the
    /// other sees the front of.
    double score = 0;
  };

  /// A surface with a viewpoint that the user gave is copied, for its normals to be oriented to it;
  /// any other is shared. The kernels must outlive this. Throws as SurfaceFit does.
  Ranking(const SharedSurface& source, const SharedSurface& target,
          const std::optional<Viewpoint>& source_viewpoint,
          const std::optional<Viewpoint>& target_viewpoint, const Kernels& kernels);
  Ranking(const Ranking&) = delete;
  Ranking& operator=(const Ranking&) = delete;

  /// Scores by every `step`-th point, all by default; fewer are for a first pass over many poses
  /// (see SurfaceFit::add_subset).
  Value evaluate(const Rigid& pose, Scratch& scratch, std::size_t step = 1) const;
  SurfaceFit& fit() { return fit_; }
  const SurfaceFit& fit() const { return fit_; }

 private:
  const bool both_given_;
  SurfaceFit fit_;
  FreeSpace free_space_;
};

}  // namespace emtr
