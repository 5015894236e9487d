#pragma once

#include <limits>

#include "ranking/surface_fit.h"
#include "ranking/free_space.h"

namespace emtr {

/// The score by which candidate poses are ranked: how well the surfaces lie on each other, less
/// how much they stand where the other's sensor saw nothing.
class Ranking {
 public:
  struct Scratch {
    SurfaceFit::Scratch fit;
    FreeSpace::Scratch free_space;
  };

  struct Value {
    SurfaceFitValue fit;
    double violation = 0;
    /// fit.chf - 2 violation, at most 1. With fit.same_side in the place of fit.chf where the
    /// viewpoints of both are given: no sensor sees the back of what the other sees the front of.
    double score = 0;
  };

  /// The surfaces are copied, and their normals turned to the viewpoints where there are any. The
  /// kernels must outlive this. Throws as Fit does.
  Ranking(Surface source, Surface target, const Viewpoints& of_source, const Viewpoints& of_target,
          const Kernels& kernels);
  Ranking(const Ranking&) = delete;
  Ranking& operator=(const Ranking&) = delete;

  /// A pose whose fit alone does not exceed `least` is left at that: its score, which is no more
  /// than that of its fit, is then given without looking for violations.
  Value evaluate(const Rigid& pose, Scratch& scratch,
                 double least = -std::numeric_limits<double>::infinity()) const;

  /// For a first pass over many poses: by every step-th point alone (see Fit::prepare).
  Value quick(const Rigid& pose, std::size_t step, Scratch& scratch) const;
  SurfaceFit& fit() { return fit_; }
  const SurfaceFit& fit() const { return fit_; }

 private:
  const Surface source_, target_;
  const bool both_given_;
  SurfaceFit fit_;
  FreeSpace free_space_;
};

}  // namespace emtr
