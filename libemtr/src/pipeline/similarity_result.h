#pragma once

#include <vector>

#include "pipeline/problem.h"
#include "pipeline/result.h"
#include "pipeline/scale_search.h"
#include "pipeline/solution.h"
#include "refinement/similarity_refinement.h"

namespace emtr {

/// Refines scale and pose of a solution together, on the fine surfaces.
SimilarityFit refine_similarity(const Problem& problem, const Solution& found);

/// Makes the result of a rigid run, of the source at a scale, that of a similarity. `fit`:
/// refined in that run; `scale_is_exact`: the scale is not to be refined.
void write_similarity(const Problem& problem, const Solution& found, double scale,
                      const SimilarityFit& fit, bool scale_is_exact, Result& result);

/// Lowers the confidence where the surfaces leave the scale open, or prefer another one to an exact
/// one.
void judge_scale(const SimilarityFit& fit, bool scale_is_exact, const Settings& settings,
                 Result& result);

}  // namespace emtr
