#include "resolution.h"

#include <pcl/kdtree/kdtree_flann.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "../team.h"
#include "cell_grid.h"
#include "pcl_cloud.h"

namespace emtr {
namespace {

struct Scratch {
  std::vector<CellGrid::Range> ranges;
  NeighborList list;
};

/// The squared distance of a sorted point to the nearest other one of the list.
float to_nearest_other(std::uint32_t i, const CellGrid& grid, NeighborList& list,
                       const Kernels& kernels) {
  const float query[3] = {grid.sorted.x[i], grid.sorted.y[i], grid.sorted.z[i]};
  const auto itself = static_cast<std::size_t>(
      std::lower_bound(list.rows.begin(), list.rows.end(), i) - list.rows.begin());
  list.points.x[itself] = kFarAway;
  const float squared = kernels.least_squared(list.points.view(), query);
  list.points.x[itself] = query[0];
  return squared;
}

}  // namespace

double mean_resolution(const Cloud& cloud, std::size_t most) {
  const auto points = to_pcl(cloud);
  pcl::KdTreeFLANN<pcl::PointXYZ> tree;
  tree.setInputCloud(points);
  pcl::Indices index(2);
  std::vector<float> squared(2);
  const std::size_t step = std::max<std::size_t>(1, cloud.size() / most);
  double sum = 0;
  std::size_t asked = 0;
  for (std::size_t i = 0; i < cloud.size(); i += step, ++asked) {
    poll_each(asked, 6);
    tree.nearestKSearch((*points)[i], 2, index, squared);
    sum += std::sqrt(static_cast<double>(squared[1]));
  }
  return sum / static_cast<double>(asked);
}

double mean_resolution(const Cloud& cloud, double leaf, const Kernels& kernels, int threads) {
  const CellGrid grid(cloud, 1.5 * leaf);
  std::vector<Scratch> scratch(static_cast<std::size_t>(threads));
  std::vector<float> squared(cloud.size());
  const auto measure = [&](std::size_t cell, std::size_t thread) {
    std::vector<CellGrid::Range>& ranges = scratch[thread].ranges;
    NeighborList& list = scratch[thread].list;
    std::vector<std::uint32_t> left;  // points whose nearest one may be beyond the cells seen
    for (std::uint32_t i = grid.begin(cell); i < grid.end(cell); ++i) left.push_back(i);
    for (int reach = 1; !left.empty(); reach *= 2) {
      grid.around(cell, reach, ranges);
      list.gather(grid.sorted, ranges);
      const double seen = reach * grid.side() * (1 - 1e-5);
      const auto beyond = [&](std::uint32_t i) {
        const float nearest = to_nearest_other(i, grid, list, kernels);
        squared[static_cast<std::size_t>(grid.rows[i])] = nearest;
        return double{nearest} > seen * seen && !grid.spans(reach);
      };
      left.erase(std::remove_if(left.begin(), left.end(), std::not_fn(beyond)), left.end());
    }
  };
  Team::with(threads, [&](Team& team) { for_each_cell(grid, team, measure); });
  double sum = 0;
  for (const float distance : squared) sum += std::sqrt(static_cast<double>(distance));
  return sum / static_cast<double>(cloud.size());
}

}  // namespace emtr
