#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/similarity.h"
#include "geometry/transform.h"
#include "kernels/kernels.h"
#include "neighbors/neighbors.h"
#include "refinement/query_points.h"

namespace emtr {

/// Pairs the query points of either surface with the nearest points of the other one.
class SurfaceMatcher {
 public:
  /// Working memory; grow() it to hold all runs that are worked on at once.
  struct Scratch {
    std::vector<float> x, y, z, squared;
    std::vector<std::int32_t> index;

    void grow(std::size_t size);
  };

  /// A run of queries of one side, and where in the scratch they are worked on.
  struct Run {
    bool reversed;  ///< the target's queries, not the source's
    std::size_t begin, end, offset;
  };

  /// `near_source`, `near_target`: neighbors of the points of each; the former may be null when no
  /// run is reversed. They and the kernels must outlive this.
  SurfaceMatcher(QueryPoints source, QueryPoints target, const Neighbors* near_source,
                 const Neighbors* near_target, const Kernels& kernels);

  const QueryPoints& source() const { return source_; }
  const QueryPoints& target() const { return target_; }

  /// Calls visit(source, target) for each query that has a match within `reach` under the pose, a
  /// Rigid or a Similarity. The target's queries measure the reach in the source's unit.
  template <class Pose, class Visit>
  void for_each_match(const Pose& pose, double reach, const Run& run, Scratch& s,
                      const Visit& visit) const {
    const bool reversed = run.reversed;
    const QueryPoints &asking = reversed ? target_ : source_,
                      &answering = reversed ? source_ : target_;
    const Neighbors& near = reversed ? *near_source_ : *near_target_;
    const std::size_t n = run.end - run.begin, at = run.offset;
    float *x = &s.x[at], *y = &s.y[at], *z = &s.z[at], *squared = &s.squared[at];
    std::int32_t* index = &s.index[at];
    transform(kernels_, asking.view(run.begin, run.end), reversed ? pose.inverse() : pose, x, y, z);
    near.nearest({x, y, z, n}, index, squared);

    const auto limit = static_cast<float>(reach * reach);
    const SurfacePoint *queries = asking.surface(), *neighbors = answering.surface();
    const std::int32_t* rows = asking.rows() + run.begin;
    for (std::size_t i = 0; i < n; ++i) {
      if (index[i] < 0 || !(squared[i] < limit)) continue;
      const SurfacePoint &a = queries[rows[i]], &b = neighbors[index[i]];
      visit(reversed ? b : a, reversed ? a : b);
    }
  }

 private:
  const QueryPoints source_, target_;
  const Neighbors *near_source_, *near_target_;
  const Kernels& kernels_;
};

}  // namespace emtr
