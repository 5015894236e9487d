#pragma once

#include <emtr/emtr.h>

#include "pipeline/problem.h"
#include "c_api/problem_arrays.h"
#include "c_api/arguments.h"

// What the opaque types of the C API are.

struct emtr_problem : emtr::Problem {
  using Problem::Problem;
  emtr::ProblemArrays arrays{*this};
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
