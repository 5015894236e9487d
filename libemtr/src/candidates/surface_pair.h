#pragma once

#include <memory>
#include <optional>

#include "features/fpfh.h"
#include "geometry/surface.h"
#include "ranking/ranking.h"
#include "refinement/local_refinement.h"

namespace emtr {

/// Both dense clouds as surfaces, with what refines and scores candidates on them.
class SurfacePair {
 public:
  static constexpr std::size_t kQuickStep = 8;      ///< quick scores look at every eighth point
  static constexpr std::size_t kQuickestStep = 32;  ///< and before them at every 32nd

  /// Shares the surfaces. Where a viewpoint is not known, free space is not taken into account.
  /// Throws std::invalid_argument as SurfaceFit does.
  SurfacePair(const SharedSurface& source, const SharedSurface& target,
              const std::optional<Viewpoint>& source_viewpoint,
              const std::optional<Viewpoint>& target_viewpoint, const Kernels& kernels);
  /// Makes what a pair looks for in the memory of its target, but for what its ranking does.
  static void make_ahead(const SharedSurface& target, const Kernels& kernels);
  SurfacePair(const SurfacePair&) = delete;
  SurfacePair& operator=(const SurfacePair&) = delete;

  const SharedSurface& shared_source() const { return source_; }
  const SharedSurface& shared_target() const { return target_; }
  const Surface& source() const { return *source_; }
  const Surface& target() const { return *target_; }
  const std::optional<Viewpoint>& source_viewpoint() const { return source_viewpoint_; }
  const std::optional<Viewpoint>& target_viewpoint() const { return target_viewpoint_; }
  const Ranking& ranking() const { return ranking_; }
  /// Nearest points of the target, within four leaves.
  const Neighbors& near_target() const { return *near_target_; }
  const LocalRefinement& local_refinement() const { return local_refinement_; }

 private:
  const SharedSurface source_, target_;
  const std::optional<Viewpoint> source_viewpoint_, target_viewpoint_;
  Ranking ranking_;
  SharedNeighbors near_target_;
  LocalRefinement local_refinement_;
};

/// Makes a surface of a cloud and the normals that were found for it.
Surface surface(const Cloud& cloud, const Features& features, double leaf);

}  // namespace emtr
