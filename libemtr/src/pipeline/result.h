#pragma once

#include <emtr/emtr.h>

#include <vector>

namespace emtr {

/// An emtr_result and the memory that its pointers refer to.
struct Result : emtr_result {
  Result() : emtr_result{} { size = sizeof(emtr_result); }
  std::vector<double> alpha, beta;       ///< the memory of history_alpha and history_beta
  std::vector<emtr_alternative> others;  ///< the memory of alternatives
};

}  // namespace emtr
