#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

#include "kernels/search_kernels.h"
#include "neighbors/cells.h"
#include "neighbors/neighbors.h"
#include "util/cancellation.h"

namespace emtr {
namespace {

// Limits that keep a grid below 300 MB. Only a cloud of more points than kMaximumCandidates exceeds
// the second.
constexpr double kMaximumCells = 1 << 22;
constexpr std::size_t kMaximumCandidates = std::size_t{1} << 24;
constexpr double kMaximumVisits = 1 << 28;  // of points to cells while it is made: a second
constexpr std::size_t kLine = 16;           // floats of a cache line
constexpr std::size_t kPiece = 64;          // points between two looks whether to go on
/// Widens squared distances between boxes and points, as the margin widens boxes, so that rounding
/// leaves out no candidate.
constexpr float kSlack = 1e-4f;

class CandidateGrid final : public Neighbors {
 public:
  CandidateGrid(const Cloud& cloud, float radius, float cell, const Kernels& kernels)
      : kernels_(kernels), radius_(radius), cell_(cell) {
    do {  // nothing is near a query outside of the border of one radius
      const CellLayout layout =
          make_cell_layout(cloud, radius, radius * (1 + kSlack), cell_, kMaximumCells);
      view_.cells = layout.view;
      cell_ = layout.cell;
      margin_ = layout.margin;
    } while (!list(cloud));
    view_.cells.groups = occupied_->groups();
    view_.more = more_.data();
    view_.blocks = blocks_;
  }

  void squared_distances(const PointsView& queries, float* out) const override {
    kernels_.squared_distances(view_, queries, out);
  }

  void nearest(const PointsView& queries, std::int32_t* index, float* squared) const override {
    kernels_.nearest(view_, queries, index, squared);
    for (std::size_t i = 0; i < queries.size; ++i)
      if (index[i] >= 0) index[i] = index_[static_cast<std::size_t>(index[i])];
  }

 private:
  /// Calls visit(points, row of the first) for a few points at a time.
  template <class Visit>
  static void for_each_piece(const Cloud& cloud, Visit visit) {
    for (std::size_t first = 0; first < cloud.size(); first += kPiece) {
      check_cancelled();
      PointsView piece = cloud.view();
      piece.x += first, piece.y += first, piece.z += first;
      piece.size = std::min(kPiece, piece.size - first);
      visit(piece, first);
    }
  }

  /// Lists each cell's candidates. Enlarges the cells and returns false when they are too many.
  bool list(const Cloud& cloud) {
    const std::size_t cells = static_cast<std::size_t>(view_.cells.size[0]) *
                              static_cast<std::size_t>(view_.cells.size[1]) *
                              static_cast<std::size_t>(view_.cells.size[2]);
    const double visits = static_cast<double>(cloud.size()) *
                          std::pow(2.0 * static_cast<double>(radius_ / cell_) + 1, 3);
    if (cells > 1 && visits > kMaximumVisits) {
      cell_ *= 1.5f;
      return false;
    }
    const SearchKernels& kernels = search_kernels(kernels_);
    const ReachView grid = {view_.cells, radius_, cell_, margin_};
    std::vector<float> room(reach_room(grid));
    // Bounds the distance to the nearest point, wherever in the cell the query lies.
    std::vector<float> bound(cells + kLanes, view_.cells.limit);
    for_each_piece(cloud, [&](const PointsView& points, std::size_t) {
      kernels.reach_bounds(grid, points, room.data(), bound.data());
    });
    for (float& b : bound) b *= 1 + kSlack;
    std::vector<std::uint32_t> count(cells + kLanes, 0);
    for_each_piece(cloud, [&](const PointsView& points, std::size_t) {
      kernels.count_candidates(grid, points, room.data(), bound.data(), count.data());
    });
    const std::size_t most = cells == 1 ? cloud.size() : kMaximumCandidates / 2;
    if (std::accumulate(count.begin(), count.end(), std::size_t{0}) > most) {
      cell_ *= 1.5f;
      return false;
    }
    lay_blocks(count, cells);
    std::vector<std::uint32_t> filled(more_.size() - 1, 0);
    const CandidateLists lists = {count.data(), more_.data(), filled.data(), blocks_,
                                  index_.data()};
    for_each_piece(cloud, [&](const PointsView& points, std::size_t first) {
      kernels.list_candidates(grid, points, first, room.data(), bound.data(), lists);
    });
    return true;
  }

  /// Lays out the first block of each occupied cell, in the order of cells, then all others. Puts
  /// the place of the cell among the occupied ones where its count was.
  void lay_blocks(std::vector<std::uint32_t>& count, std::size_t cells) {
    occupied_.emplace(cells);
    for (std::size_t c = 0; c < cells; ++c)
      if (count[c] > 0) occupied_->set(c);
    occupied_->count();
    auto blocks = static_cast<std::uint32_t>(occupied_->size());
    more_.clear();
    occupied_->for_each([&](std::size_t c) {
      const std::uint32_t beyond = (count[c] - 1) / static_cast<std::uint32_t>(kLanes);
      count[c] = static_cast<std::uint32_t>(more_.size());
      more_.push_back(blocks);
      blocks += beyond;
    });
    more_.push_back(blocks);
    store_.assign(std::size_t{blocks} * 3 * kLanes + kLine, kFarAway);
    const std::size_t past =
        reinterpret_cast<std::uintptr_t>(store_.data()) / sizeof(float) % kLine;
    blocks_ = store_.data() + (kLine - past) % kLine;
    index_.assign(std::size_t{blocks} * kLanes, -1);
  }

  const Kernels& kernels_;
  GridView view_{};
  float radius_, cell_, margin_ = 0;  // margin in cells
  std::optional<Occupancy> occupied_;
  std::vector<std::uint32_t> more_;
  std::vector<float> store_;
  float* blocks_ = nullptr;          // in there, on a line of the cache
  std::vector<std::int32_t> index_;  // candidates' rows in the cloud, -1 for padding
};

}  // namespace

std::unique_ptr<Neighbors> make_candidate_grid(const Cloud& cloud, float radius, float cell,
                                               const Kernels& kernels) {
  return std::make_unique<CandidateGrid>(cloud, radius, cell, kernels);
}

}  // namespace emtr
