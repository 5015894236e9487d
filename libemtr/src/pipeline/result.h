#pragma once

#include <emtr/emtr.h>

#include <vector>

namespace emtr {

/// An emtr_result together with the memory that its pointers refer to.
struct Result : emtr_result {
  Result() : emtr_result{} { size = sizeof(emtr_result); }
  std::vector<double> alpha, beta;       ///< what history_alpha and history_beta point to
  std::vector<emtr_alternative> others;  ///< what alternatives points to
};

}  // namespace emtr
