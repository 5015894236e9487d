#pragma once

#include <memory>

#include "../features/fpfh.h"
#include "../ranking/fit.h"
#include "../ranking/free_space.h"
#include "../refinement/local_polish.h"

namespace emtr {

/// What candidates are polished and scored on: both clouds as surfaces, with their structures.
class Ranking {
 public:
  static constexpr std::size_t kQuickStep = 8;  ///< a shortlist looks at every eighth point

  Ranking(Surface source, Surface target, const Kernels& kernels);
  /// The same with free space: normals turned to the first viewpoint of each that has any.
  Ranking(const Ranking& other, Viewpoints of_source, Viewpoints of_target, const Kernels& kernels);
  Ranking& operator=(const Ranking&) = delete;

  const Surface& source() const { return source_; }
  const Surface& target() const { return target_; }
  const Fit& fit() const { return fit_; }
  const LocalPolish& polish() const { return polish_; }
  const FreeSpace* free_space() const { return free_space_.get(); }  ///< null when unknown
  const Viewpoints& of_source() const { return of_source_; }
  const Viewpoints& of_target() const { return of_target_; }

 private:
  Surface source_, target_;
  Viewpoints of_source_, of_target_;
  Fit fit_;
  std::unique_ptr<Neighbors> near_target_;
  LocalPolish polish_;
  std::unique_ptr<FreeSpace> free_space_;
};

/// The feature cloud with its normals.
Surface surface(const Cloud& cloud, const Features& features, double leaf);

}  // namespace emtr
