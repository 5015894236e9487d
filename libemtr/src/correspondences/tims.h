#pragma once

#include <cstddef>
#include <vector>

#include "correspondences/correspondence.h"
#include "geometry/cloud.h"

namespace emtr {

/// Translation invariant measurements (TIMs): p_jk = p_k - p_j and q_jk = q_k - q_j over all pairs
/// of correspondences, so that q_jk = R p_jk but for noise.
struct Tims {
  Cloud source, target;
  Cloud ends_source, ends_target;  ///< the correspondences themselves
  std::size_t pruned = 0;          ///< left out of the arrays: outliers under every rotation

  std::size_t size() const { return source.size(); }
  std::size_t formed() const { return size() + pruned; }
};

/// Forms the TIMs of all pairs and prunes those with | |p| - |q| | >= threshold: |q - R p| is never
/// smaller than that.
Tims form_tims(const Cloud& source, const Cloud& target,
               const std::vector<Correspondence>& correspondences, double threshold);

/// Returns the largest number of correspondences that have at most `max_tims` pairs.
std::size_t correspondence_cap(std::size_t max_tims);

}  // namespace emtr
