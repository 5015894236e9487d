#pragma once

#include <vector>

#include "pipeline/result.h"
#include "preprocessing/preprocessed_cloud.h"

namespace emtr {

/// The smaller of two clouds, by whose size their poses are compared.
struct SmallCloud {
  const PreprocessedCloud& cloud;
  bool is_source;
};

/// Tells whether the run was stopped before its end.
bool is_stopped(const Result& result);

/// Counts results of the same two clouds, found in other ways, among the answers: one that moves
/// the small cloud to another place and scores nearly as well is an alternative of `best`, and
/// lowers its confidence, once. Without it more search would only make a result surer.
void weigh_rivals(const std::vector<const Result*>& others, const SmallCloud& small, double minimum,
                  Result& best);

}  // namespace emtr
