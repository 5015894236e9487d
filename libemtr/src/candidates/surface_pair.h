#pragma once

#include <memory>

#include "features/fpfh.h"
#include "ranking/ranking.h"
#include "refinement/local_refinement.h"
#include "geometry/surface.h"

namespace emtr {

/// Both dense clouds as surfaces, with what candidates are polished and scored by.
class SurfacePair {
 public:
  static constexpr std::size_t kQuickStep = 8;  ///< a shortlist looks at every eighth point

  /// Viewpoints without candidates: free space says nothing.
  SurfacePair(Surface source, Surface target, const Viewpoints& of_source, const Viewpoints& of_target,
           const Kernels& kernels);
  SurfacePair(const SurfacePair&) = delete;
  SurfacePair& operator=(const SurfacePair&) = delete;

  const Surface& source() const { return source_; }
  const Surface& target() const { return target_; }
  const Ranking& ranking() const { return ranking_; }
  const LocalRefinement& local_refinement() const { return local_refinement_; }

 private:
  Surface source_, target_;
  Ranking ranking_;
  std::unique_ptr<Neighbors> near_target_;
  LocalRefinement local_refinement_;
};

/// The feature cloud with its normals.
Surface surface(const Cloud& cloud, const Features& features, double leaf);

}  // namespace emtr
