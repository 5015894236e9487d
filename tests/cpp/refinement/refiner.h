#pragma once

#include <memory>
#include <utility>

#include "kernels/kernels.h"
#include "neighbors/neighbors.h"
#include "refinement/local_refinement.h"

namespace emtr_test {

/// Two surfaces with their neighbors and the refinement between them.
struct Refiner {
  emtr::Surface source, target;
  std::unique_ptr<emtr::Neighbors> near_source, near_target;
  std::unique_ptr<emtr::LocalRefinement> local_refinement;

  Refiner(emtr::Surface from, emtr::Surface to, const emtr::LocalRefinementSettings& settings,
          const emtr::Kernels& kernels = emtr::select_kernels())
      : source(std::move(from)), target(std::move(to)) {
    const auto leaf = static_cast<float>(target.leaf);
    const float radius = leaf * static_cast<float>(std::max(settings.first_scale, settings.reach));
    near_source = emtr::make_candidate_grid(source.points, radius, 2 * leaf, kernels);
    near_target = emtr::make_candidate_grid(target.points, radius, 2 * leaf, kernels);
    local_refinement = std::make_unique<emtr::LocalRefinement>(
        source, target, near_source.get(), near_target.get(), settings, kernels);
  }

  emtr::LocalRefinementResult operator()(const emtr::Rigid& start, int threads = 1) const {
    emtr::LocalRefinement::Scratch scratch;
    return (*local_refinement)(start, nullptr, scratch, threads);
  }
};

}  // namespace emtr_test
