#pragma once

#include <emtr/emtr.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <utility>

#include "c_api/arguments.h"
#include "c_api/problem_arrays.h"
#include "pipeline/problem.h"

// The opaque types of the C API.

struct emtr_problem {
  explicit emtr_problem(std::unique_ptr<const emtr::Problem> made)
      : data(std::move(made)), arrays(*data) {}

  const std::unique_ptr<const emtr::Problem> data;
  const emtr::ProblemArrays arrays;
  std::atomic<std::uint64_t> queries{0};  ///< those of the functions that work stage by stage
};

struct emtr_preprocessed {
  emtr::PreprocessedCloudPtr cloud;
};

namespace emtr {

inline emtr_problem& checked(emtr_problem* problem) { return required(problem, "problem"); }
inline const emtr_problem& checked(const emtr_problem* problem) {
  return required(problem, "problem");
}

}  // namespace emtr
