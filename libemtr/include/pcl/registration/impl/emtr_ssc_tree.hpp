#pragma once

#include <pcl/search/kdtree.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace pcl {
namespace detail {

/** \brief Answers queries for which PCL's kd-tree stops the process: a query point that is not
 * finite has no neighbors, and a tree without a finite point gives none.
 *
 * Registration::getFitnessScore() queries the neighbor of every source point and reads the first
 * distance without checking that it exists. So a query without neighbors gets an infinite one. */
template <typename PointT>
class FiniteKdTree : public search::KdTree<PointT> {
 public:
  using Base = search::KdTree<PointT>;
  using Base::nearestKSearch;

  int nearestKSearch(const PointT& point, int k, Indices& k_indices,
                     std::vector<float>& k_sqr_distances) const override {
    if (this->getPointRepresentation()->isValid(point)) {
      const int found = Base::nearestKSearch(point, k, k_indices, k_sqr_distances);
      if (found > 0) return found;
    }
    const auto size = static_cast<std::size_t>(std::max(k, 0));
    k_indices.assign(size, UNAVAILABLE);
    k_sqr_distances.assign(size, std::numeric_limits<float>::infinity());
    return 0;
  }
};

}  // namespace detail
}  // namespace pcl
