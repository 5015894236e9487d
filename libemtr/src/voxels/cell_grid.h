#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "geometry/cloud.h"
#include "util/thread_team.h"

namespace emtr {

/// The points of a cloud sorted by cubic cell, x fastest, so that a row of cells is one stretch of
/// memory. Serves searches within a radius.
class CellGrid {
 public:
  /// Makes cells of `side` or, where that would make far more cells than points, larger ones.
  CellGrid(const Cloud& cloud, double side);

  /// Returns the number of cells that hold points; they are numbered in the order of `sorted`.
  std::size_t occupied() const { return occupied_.size(); }
  std::uint32_t begin(std::size_t cell) const { return begin_[occupied_[cell]]; }
  std::uint32_t end(std::size_t cell) const { return begin_[occupied_[cell] + 1]; }

  double side() const { return side_; }  ///< of the cells in use
  bool spans(int reach) const;           ///< whether every cell reaches all the others

  /// Returns how many cells away a point that is nearer than `radius` can lie.
  int reach(double radius) const;

  /// A stretch of `sorted`.
  struct Range {
    std::uint32_t begin, end;
  };
  /// Writes the ranges of all points up to `reach` cells from an occupied one, in ascending order.
  void around(std::size_t cell, int reach, std::vector<Range>& out) const;

  Cloud sorted;
  std::vector<std::int32_t> rows;  ///< in the cloud, of each sorted point

 private:
  std::int64_t size_[3];
  double side_;
  std::vector<std::uint32_t> begin_, occupied_;
};

/// Calls work(cell, thread) for each occupied cell.
template <class Work>
void for_each_cell(const CellGrid& grid, ThreadTeam& team, const Work& work) {
  constexpr std::size_t cells_per_job = 16;  // one cell is too little work for a job
  const std::size_t jobs = (grid.occupied() + cells_per_job - 1) / cells_per_job;
  team.parallel(jobs, [&](std::size_t job, std::size_t thread) {
    const std::size_t end = std::min(grid.occupied(), (job + 1) * cells_per_job);
    for (std::size_t cell = job * cells_per_job; cell < end; ++cell) work(cell, thread);
  });
}

/// The points near one cell as one list for the kernels, padded to kListStep.
struct NeighborList {
  Cloud points;
  std::vector<std::uint32_t> rows;  ///< in the grid's `sorted`

  void gather(const Cloud& sorted, const std::vector<CellGrid::Range>& ranges);
  std::size_t size() const { return points.size(); }
};

}  // namespace emtr
