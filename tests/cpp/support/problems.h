#pragma once

#include <memory>

#include "pipeline/problem.h"
#include "pipeline/solve.h"

namespace emtr_test {

using ProblemPtr = std::unique_ptr<const emtr::Problem>;
using ResultPtr = std::unique_ptr<emtr::Result>;

inline ProblemPtr problem_of(const emtr_cloud& source, const emtr_cloud& target,
                             const emtr::Settings& settings,
                             const emtr::OnProgress& on_progress = nullptr) {
  emtr::InputCloud from{&source, nullptr}, to{&target, nullptr};
  emtr::CancellationToken token(on_progress);
  return emtr::make_problem(from, to, settings, token);
}

inline ProblemPtr problem_of(const emtr::PreprocessedCloudPtr& source,
                             const emtr::PreprocessedCloudPtr& target,
                             const emtr::Settings& settings,
                             const emtr::OnProgress& on_progress = nullptr) {
  emtr::InputCloud from{nullptr, source}, to{nullptr, target};
  emtr::CancellationToken token(on_progress);
  return emtr::make_problem(from, to, settings, token);
}

/// Solves a problem within the time limit of its settings.
inline ResultPtr solve(const emtr::Problem& problem,
                       const emtr::OnProgress& on_progress = nullptr) {
  emtr::CancellationToken token(on_progress, problem.settings.time_limit);
  return emtr::solve(problem, token);
}

}  // namespace emtr_test
