#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "geometry/rigid.h"
#include "seeds/consistency.h"

namespace emtr {

/// Three consistent matches, and those that are consistent with each and fit their pose.
struct Triangle {
  Rigid pose;                          ///< fitted to all of them
  std::vector<std::uint32_t> matches;  ///< the three and the others
};

/// Returns the triangles of the most matches, the largest first, at most 24 and none of them inside
/// another. All triangles are looked at but those that have too few matches in common to be as good
/// as what was found, and what is left of very many. `reach`: largest residual of a match that
/// fits; `least`: how many matches a triangle must have. Asks `is_enough` about a triangle that has
/// half as many matches again as the one before, and ends when that is so.
std::vector<Triangle> find_triangles(const Consistency& consistency, double reach,
                                     std::size_t least,
                                     const std::function<bool(const Triangle&)>& is_enough);

}  // namespace emtr
