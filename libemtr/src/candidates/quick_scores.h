#pragma once

#include <cstddef>
#include <vector>

#include "candidates/surface_pair.h"
#include "geometry/rigid.h"
#include "util/thread_team.h"

namespace emtr {

/// Returns the score of a pose by every eighth point of both surfaces.
double quick_score(const SurfacePair& surfaces, const Rigid& pose, Ranking::Scratch& scratch);

/// Returns the rows of the poses, the best first. A look at every 32nd point says which of them
/// deserve a quick score, twice `most` and a quarter of all at least; the others come after them.
std::vector<std::size_t> order_by_quick_scores(const SurfacePair& surfaces,
                                               const std::vector<Rigid>& poses, std::size_t most,
                                               ThreadTeam& team);

/// Returns the quick score of each pose; minus infinity for one that by every 32nd point has less
/// than half of `promising` times what the pose of row `best` has.
std::vector<double> promising_quick_scores(const SurfacePair& surfaces,
                                           const std::vector<Rigid>& poses, std::size_t best,
                                           double promising, ThreadTeam& team);

}  // namespace emtr
