#pragma once

#include <memory>

#include "features/fpfh.h"
#include "geometry/surface.h"
#include "ranking/ranking.h"
#include "refinement/local_refinement.h"

namespace emtr {

/// Both dense clouds as surfaces, with what refines and scores candidates on them.
class SurfacePair {
 public:
  static constexpr std::size_t kQuickStep = 8;  ///< a shortlist looks at every eighth point

  /// Shares the surfaces. Without viewpoints free space is not taken into account. Throws
  /// std::invalid_argument as SurfaceFit does.
  SurfacePair(const SharedSurface& source, const SharedSurface& target,
              const Viewpoints& source_viewpoints, const Viewpoints& target_viewpoints,
              const Kernels& kernels);
  SurfacePair(const SurfacePair&) = delete;
  SurfacePair& operator=(const SurfacePair&) = delete;

  const SharedSurface& shared_source() const { return source_; }
  const SharedSurface& shared_target() const { return target_; }
  const Surface& source() const { return *source_; }
  const Surface& target() const { return *target_; }
  const Ranking& ranking() const { return ranking_; }
  const LocalRefinement& local_refinement() const { return local_refinement_; }

 private:
  const SharedSurface source_, target_;
  Ranking ranking_;
  std::unique_ptr<Neighbors> near_target_;
  LocalRefinement local_refinement_;
};

/// Makes a surface of a cloud and the normals that were found for it.
Surface surface(const Cloud& cloud, const Features& features, double leaf);

}  // namespace emtr
