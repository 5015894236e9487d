#include "neighbors/resolution.h"

#include <pcl/kdtree/kdtree_flann.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <type_traits>

#include "geometry/pcl_cloud.h"
#include "util/thread_team.h"
#include "voxels/cell_grid.h"

namespace emtr {
namespace {

struct Scratch {
  std::vector<CellGrid::Range> ranges;
  NeighborList list;
};

/// Returns the squared distance of a sorted point to the nearest other one of the list.
float to_nearest_other(std::uint32_t i, const CellGrid& grid, NeighborList& list,
                       const Kernels& kernels) {
  const float query[3] = {grid.sorted.x[i], grid.sorted.y[i], grid.sorted.z[i]};
  const auto itself = static_cast<std::size_t>(
      std::lower_bound(list.rows.begin(), list.rows.end(), i) - list.rows.begin());
  list.points.x[itself] = kFarAway;
  const float squared = kernels.minimum_squared_distance(list.points.view(), query);
  list.points.x[itself] = query[0];
  return squared;
}

class Tree {
 public:
  explicit Tree(const Cloud& cloud) : points_(to_pcl(cloud)) { tree_.setInputCloud(points_); }

  float squared_to_other(std::size_t i) {
    search(i, 2);
    return squared_[1];
  }

  /// Returns 0 when all points are at one place.
  float squared_to_other_place(std::size_t i) {
    for (std::size_t k = 2;; k = std::min(2 * k, points_->size())) {
      search(i, k);
      for (const float squared : squared_)
        if (squared > 0) return squared;
      if (k == points_->size()) return 0;
    }
  }

 private:
  void search(std::size_t i, std::size_t k) {
    tree_.nearestKSearch((*points_)[i], static_cast<unsigned>(k), index_, squared_);
  }

  pcl::PointCloud<pcl::PointXYZ>::Ptr points_;
  pcl::KdTreeFLANN<pcl::PointXYZ> tree_;
  pcl::Indices index_;
  std::vector<float> squared_;
};

}  // namespace

double mean_resolution(const Cloud& cloud) {
  Tree tree(cloud);
  double sum = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    sum += std::sqrt(static_cast<double>(tree.squared_to_other(i)));
  return sum / static_cast<double>(cloud.size());
}

double mean_spacing(const Cloud& cloud, std::size_t max_count) {
  Tree tree(cloud);
  const std::size_t step = std::max<std::size_t>(1, cloud.size() / max_count);
  double sum = 0;
  std::size_t queries = 0;
  for (std::size_t i = 0; i < cloud.size(); i += step, ++queries) {
    check_cancelled_each(queries, 6);
    sum += std::sqrt(static_cast<double>(tree.squared_to_other_place(i)));
  }
  return sum / static_cast<double>(queries);
}

double mean_resolution(const Cloud& cloud, double leaf, const Kernels& kernels, int threads) {
  const CellGrid grid(cloud, 1.5 * leaf);
  std::vector<Scratch> scratch(static_cast<std::size_t>(threads));
  std::vector<float> squared(cloud.size());
  const auto measure = [&](std::size_t cell, std::size_t thread) {
    std::vector<CellGrid::Range>& ranges = scratch[thread].ranges;
    NeighborList& list = scratch[thread].list;
    std::vector<std::uint32_t> left;  // points whose nearest one may lie beyond the searched cells
    for (std::uint32_t i = grid.begin(cell); i < grid.end(cell); ++i) left.push_back(i);
    for (int reach = 1; !left.empty(); reach *= 2) {
      grid.around(cell, reach, ranges);
      list.gather(grid.sorted, ranges);
      const double searched = reach * grid.side() * (1 - 1e-5);
      const auto beyond = [&](std::uint32_t i) {
        const float nearest = to_nearest_other(i, grid, list, kernels);
        squared[static_cast<std::size_t>(grid.rows[i])] = nearest;
        return double{nearest} > searched * searched && !grid.spans(reach);
      };
      left.erase(std::remove_if(left.begin(), left.end(), std::not_fn(beyond)), left.end());
    }
  };
  ThreadTeam::with(threads, [&](ThreadTeam& team) { for_each_cell(grid, team, measure); });
  double sum = 0;
  for (const float distance : squared) sum += std::sqrt(static_cast<double>(distance));
  return sum / static_cast<double>(cloud.size());
}

}  // namespace emtr
