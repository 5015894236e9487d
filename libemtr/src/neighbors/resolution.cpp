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

/// Returns the least squared distance above 0 from the query to a point of the list; infinite where
/// all of them are at its place.
float to_other_place(const float query[3], const NeighborList& list) {
  float least = HUGE_VALF;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const float dx = list.points.x[i] - query[0], dy = list.points.y[i] - query[1],
                dz = list.points.z[i] - query[2];
    const float squared = (dx * dx + dy * dy) + dz * dz;
    least = squared > 0 && squared < least ? squared : least;
  }
  return least;
}

/// The same among all points of the grid, from a sorted point of one cell; 0 where there is none.
float to_other_place(std::uint32_t i, std::size_t cell, const CellGrid& grid, Scratch& scratch) {
  const float query[3] = {grid.sorted.x[i], grid.sorted.y[i], grid.sorted.z[i]};
  for (int reach = 1;; reach *= 2) {
    grid.around(cell, reach, scratch.ranges);
    scratch.list.gather(grid.sorted, scratch.ranges);
    const float squared = to_other_place(query, scratch.list);
    const double searched = reach * grid.side() * (1 - 1e-5);
    if (double{squared} <= searched * searched) return squared;
    if (grid.spans(reach)) return squared < kFarAway ? squared : 0;
  }
}

class Tree {
 public:
  explicit Tree(const Cloud& cloud) : points_(to_pcl(cloud)) { tree_.setInputCloud(points_); }

  float squared_to_other(std::size_t i) {
    search(i, 2);
    return squared_[1];
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
  // A surface in the unit ball has an area of about 10: one point a cell, more where they crowd.
  constexpr double kArea = 10, kFinest = 0.01;
  const auto n = static_cast<double>(cloud.size());
  const CellGrid grid(cloud, std::max(kFinest, std::sqrt(kArea / n)));
  const std::size_t step = std::max<std::size_t>(1, cloud.size() / max_count);
  std::vector<float> squared((cloud.size() + step - 1) / step);
  Scratch scratch;
  for (std::size_t cell = 0; cell < grid.occupied(); ++cell) {
    check_cancelled_each(cell, 6);
    for (std::uint32_t i = grid.begin(cell); i < grid.end(cell); ++i) {
      const auto row = static_cast<std::size_t>(grid.rows[i]);
      if (row % step == 0) squared[row / step] = to_other_place(i, cell, grid, scratch);
    }
  }
  double sum = 0;
  for (const float distance : squared) sum += std::sqrt(static_cast<double>(distance));
  return sum / static_cast<double>(squared.size());
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
