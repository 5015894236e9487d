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

/// Adds results of the same two clouds that are as good an answer as `best` to its alternatives,
/// and lowers its confidence, once.
void add_rivals(const std::vector<const Result*>& rivals, double minimum, Result& best);

/// Counts results of the same two clouds, found in other ways, among the answers: one that moves
/// the small cloud to another place and scores nearly as well is a rival of `best`. Without it more
/// search would only make a result surer.
void weigh_rivals(const std::vector<const Result*>& others, const SmallCloud& small, double minimum,
                  Result& best);

}  // namespace emtr
