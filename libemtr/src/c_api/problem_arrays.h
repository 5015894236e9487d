#pragma once

#include <array>
#include <cstddef>
#include <mutex>
#include <vector>

#include "pipeline/problem.h"

namespace emtr {

/// Shows the arrays of a problem row by row. The engine keeps clouds as structures of arrays; a
/// cloud that is asked for is interleaved once and kept.
class ProblemArrays {
 public:
  struct View {
    const void* data;
    std::size_t rows, columns;
  };

  explicit ProblemArrays(const Problem& problem) : problem_(problem) {}

  /// Returns one of the arrays; throws Error when there is none of that number.
  View view(emtr_array which) const;

 private:
  View interleaved(emtr_array which, const Cloud& cloud) const;

  const Problem& problem_;
  mutable std::mutex mutex_;
  mutable std::array<std::vector<float>, EMTR_TARGET_FEATURE_ROWS + 1> rows_;
};

}  // namespace emtr
