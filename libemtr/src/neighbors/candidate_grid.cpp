#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

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
/// Widens squared distances between boxes and points, as the margin widens boxes, so that rounding
/// leaves out no candidate.
constexpr float kSlack = 1e-4f;

/// Squared distances along one axis from a point to the nearest and the farthest place of each
/// cell that it may reach.
struct Reach {
  std::int32_t low, high;  // cells, both included
  std::vector<float> nearest, farthest;
};

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
  struct Candidate {
    std::uint32_t cell, point;
  };

  void reach(float p, int axis, Reach& out) const {
    const float at = (p - view_.cells.origin[axis]) * view_.cells.inverse_cell;
    const float span = radius_ * view_.cells.inverse_cell + margin_;
    const auto cell = [&](float place) {
      return std::clamp(static_cast<std::int32_t>(std::floor(place)), 0,
                        view_.cells.size[axis] - 1);
    };
    out.low = cell(at - span);
    out.high = cell(at + span);
    out.nearest.clear();
    out.farthest.clear();
    for (std::int32_t c = out.low; c <= out.high; ++c) {
      const float low = static_cast<float>(c) - margin_ - at;
      const float high = static_cast<float>(c) + 1 + margin_ - at;
      const float near = cell_ * std::max({low, 0.0f, -high});
      const float far = cell_ * std::max(-low, high);
      out.nearest.push_back(near * near);
      out.farthest.push_back(far * far);
    }
  }

  /// Calls visit(cell, point, nearest, farthest) for each point and each cell that it may reach,
  /// point after point, until a call returns false. Returns whether none did.
  template <class Visit>
  bool for_each_reach(const Cloud& cloud, Visit visit) const {
    std::array<Reach, 3> r;
    for (std::size_t n = 0; n < cloud.size(); ++n) {
      check_cancelled_each(n, 6);
      reach(cloud.x[n], 0, r[0]);
      reach(cloud.y[n], 1, r[1]);
      reach(cloud.z[n], 2, r[2]);
      for (std::int32_t k = r[2].low; k <= r[2].high; ++k)
        for (std::int32_t j = r[1].low; j <= r[1].high; ++j) {
          const auto y = static_cast<std::size_t>(j - r[1].low),
                     z = static_cast<std::size_t>(k - r[2].low);
          const float near = r[1].nearest[y] + r[2].nearest[z];
          const float far = r[1].farthest[y] + r[2].farthest[z];
          const std::ptrdiff_t row = std::ptrdiff_t{k} * view_.cells.size[1] + j;
          const auto first = static_cast<std::size_t>(row * view_.cells.size[0] + r[0].low);
          for (std::size_t x = 0; x < r[0].nearest.size(); ++x)
            if (!visit(first + x, n, near + r[0].nearest[x], far + r[0].farthest[x])) return false;
        }
    }
    return true;
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
    // Bounds the distance to the nearest point, wherever in the cell the query lies.
    std::vector<float> bound(cells, view_.cells.limit);
    for_each_reach(cloud, [&](std::size_t c, std::size_t, float, float farthest) {
      bound[c] = std::min(bound[c], farthest);
      return true;
    });
    for (float& b : bound) b *= 1 + kSlack;
    std::vector<std::uint32_t> count(cells, 0);
    std::vector<Candidate> candidates;
    const std::size_t max_candidates = cells == 1 ? cloud.size() : kMaximumCandidates / 2;
    if (!for_each_reach(cloud, [&](std::size_t c, std::size_t n, float nearest, float) {
          if (nearest > bound[c]) return true;
          ++count[c];
          candidates.push_back({static_cast<std::uint32_t>(c), static_cast<std::uint32_t>(n)});
          return candidates.size() <= max_candidates;
        })) {
      cell_ *= 1.5f;
      return false;
    }
    lay_blocks(count);
    fill(cloud, candidates);
    return true;
  }

  /// Lays out the first block of each occupied cell, in the order of cells, then all others.
  void lay_blocks(const std::vector<std::uint32_t>& count) {
    occupied_.emplace(count.size());
    for (std::size_t c = 0; c < count.size(); ++c)
      if (count[c] > 0) occupied_->set(c);
    occupied_->count();
    auto blocks = static_cast<std::uint32_t>(occupied_->size());
    more_.clear();
    for (const std::uint32_t n : count) {
      if (n == 0) continue;
      more_.push_back(blocks);
      blocks += (n - 1) / static_cast<std::uint32_t>(kLanes);
    }
    more_.push_back(blocks);
    store_.assign(std::size_t{blocks} * 3 * kLanes + kLine, kFarAway);
    const std::size_t past =
        reinterpret_cast<std::uintptr_t>(store_.data()) / sizeof(float) % kLine;
    blocks_ = store_.data() + (kLine - past) % kLine;
    index_.assign(std::size_t{blocks} * kLanes, -1);
  }

  void fill(const Cloud& cloud, const std::vector<Candidate>& candidates) {
    std::vector<std::uint32_t> filled(more_.size() - 1, 0);
    for (const Candidate& c : candidates) {
      const std::size_t k = occupied_->before(c.cell);
      const std::uint32_t rank = filled[k]++;
      const std::size_t lane = rank % kLanes,
                        block = rank < kLanes ? k : more_[k] + rank / kLanes - 1;
      float* at = &blocks_[block * 3 * kLanes + lane];
      at[0] = cloud.x[c.point];
      at[kLanes] = cloud.y[c.point];
      at[2 * kLanes] = cloud.z[c.point];
      index_[block * kLanes + lane] = static_cast<std::int32_t>(c.point);
    }
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
