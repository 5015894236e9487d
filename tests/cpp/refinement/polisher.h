#pragma once

#include <memory>

#include "kernels/kernels.h"
#include "neighbors/neighbors.h"
#include "refinement/local_polish.h"

namespace emtr_test {

/// Two surfaces with their neighbours and the polish between them.
struct Polisher {
  emtr::Surface source, target;
  std::unique_ptr<emtr::Neighbors> near_source, near_target;
  std::unique_ptr<emtr::LocalPolish> polish;

  Polisher(emtr::Surface from, emtr::Surface to, const emtr::Polish& settings,
           const emtr::Kernels& kernels = emtr::select_kernels())
      : source(std::move(from)), target(std::move(to)) {
    const auto leaf = static_cast<float>(target.leaf);
    const float radius = leaf * static_cast<float>(std::max(settings.first_scale, settings.reach));
    near_source = emtr::make_candidate_grid(source.points, radius, 2 * leaf, kernels);
    near_target = emtr::make_candidate_grid(target.points, radius, 2 * leaf, kernels);
    polish = std::make_unique<emtr::LocalPolish>(source, target, near_source.get(),
                                                 near_target.get(), settings, kernels);
  }

  emtr::Polished operator()(const emtr::Rigid& start, int threads = 1) const {
    emtr::LocalPolish::Scratch scratch;
    return (*polish)(start, nullptr, scratch, threads);
  }
};

}  // namespace emtr_test
