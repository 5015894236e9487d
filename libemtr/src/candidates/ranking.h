#pragma once

#include <memory>

#include "../features/fpfh.h"
#include "../ranking/fit.h"
#include "../refinement/local_polish.h"
#include "../settings.h"

namespace emtr {

/// What candidates are polished and scored on: both clouds as surfaces, with their structures.
class Ranking {
 public:
  static constexpr std::size_t kQuickStep = 8;  ///< a shortlist looks at every eighth point

  Ranking(Surface source, Surface target, const Kernels& kernels);
  Ranking(const Ranking&) = delete;
  Ranking& operator=(const Ranking&) = delete;

  const Fit& fit() const { return fit_; }
  const LocalPolish& polish() const { return *polish_; }

 private:
  Surface source_, target_;
  Fit fit_;
  std::unique_ptr<Neighbors> near_source_, near_target_;
  std::unique_ptr<LocalPolish> polish_;
};

/// The feature cloud with its normals.
Surface surface(const Cloud& cloud, const Features& features, double leaf);

}  // namespace emtr
