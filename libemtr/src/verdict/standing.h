#pragma once

#include "../candidates/pool.h"

namespace emtr {

/// How the best candidate stands among the others, and what may be believed of it.
struct Standing {
  double gap = 0;         ///< score minus that of the best clearly different candidate
  double confidence = 0;  ///< held probability that it is right
  std::vector<Candidate> others;  ///< clearly different from the best and from each other
};

/// `ranked`: of a pool, best first, not empty.
Standing stand(const std::vector<Candidate>& ranked);

}  // namespace emtr
