#include <algorithm>
#include <cmath>
#include <vector>

#include "neighbors.h"

namespace emtr {
namespace {

constexpr std::size_t kMostCells = std::size_t{1} << 22;
constexpr float kFar = 1e18f;  // padding: its square is finite and beyond every radius
/// Bounds of distances between boxes and points are widened by this, so that no rounding can
/// leave out a candidate.
constexpr float kSlack = 1e-4f;

struct Box {
  float low[3], high[3];
};

/// Squared distance from a point to the nearest and to the farthest place of a box.
float nearest_squared(const Box& box, const float* p) {
  float sum = 0;
  for (int a = 0; a < 3; ++a) {
    const float d = std::max({box.low[a] - p[a], 0.0f, p[a] - box.high[a]});
    sum += d * d;
  }
  return sum;
}

float farthest_squared(const Box& box, const float* p) {
  float sum = 0;
  for (int a = 0; a < 3; ++a) {
    const float d = std::max(std::abs(p[a] - box.low[a]), std::abs(p[a] - box.high[a]));
    sum += d * d;
  }
  return sum;
}

class CandidateGrid final : public Neighbors {
 public:
  CandidateGrid(const Cloud& cloud, float radius, float cell, const Kernels& kernels)
      : kernels_(kernels) {
    view_.limit = radius * radius;
    lay_out(cloud, radius, cell);
    fill(cloud, radius);
    view_.begin = begin_.data();
    view_.x = x_.data();
    view_.y = y_.data();
    view_.z = z_.data();
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
  /// Cells cover the cloud's bounding box and a margin of one radius: outside nothing is near.
  void lay_out(const Cloud& cloud, float radius, float cell) {
    const std::vector<float>* axes[3] = {&cloud.x, &cloud.y, &cloud.z};
    float extent[3];
    for (int a = 0; a < 3; ++a) {
      const auto [low, high] = std::minmax_element(axes[a]->begin(), axes[a]->end());
      view_.origin[a] = *low - radius * (1 + kSlack);
      extent[a] = *high + radius * (1 + kSlack) - view_.origin[a];
    }
    for (;; cell *= 1.25f) {
      double cells = 1;
      for (int a = 0; a < 3; ++a) {
        view_.size[a] = static_cast<std::int32_t>(std::floor(extent[a] / cell)) + 1;
        cells *= view_.size[a];
      }
      if (cells <= static_cast<double>(kMostCells)) break;
    }
    cell_ = cell;
    view_.inverse_cell = 1.0f / cell;
  }

  Box box(std::int32_t i, std::int32_t j, std::int32_t k) const {
    const std::int32_t at[3] = {i, j, k};
    Box out;
    for (int a = 0; a < 3; ++a) {
      out.low[a] = view_.origin[a] + cell_ * (static_cast<float>(at[a]) - kSlack);
      out.high[a] = view_.origin[a] + cell_ * (static_cast<float>(at[a]) + 1 + kSlack);
    }
    return out;
  }

  std::size_t key(std::int32_t i, std::int32_t j, std::int32_t k) const {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(view_.size[1]) +
            static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(view_.size[0]) +
           static_cast<std::size_t>(i);
  }

  /// Calls visit(key, box, p) for each point and each cell that it may reach.
  template <class Visit>
  void for_each_reach(const Cloud& cloud, float radius, Visit visit) const {
    for (std::size_t n = 0; n < cloud.size(); ++n) {
      const float p[3] = {cloud.x[n], cloud.y[n], cloud.z[n]};
      std::int32_t low[3], high[3];
      for (int a = 0; a < 3; ++a) {
        const float at = (p[a] - view_.origin[a]) * view_.inverse_cell,
                    reach = radius * view_.inverse_cell;
        low[a] = std::max(0, static_cast<std::int32_t>(std::floor(at - reach - kSlack)));
        high[a] =
            std::min(view_.size[a] - 1, static_cast<std::int32_t>(std::floor(at + reach + kSlack)));
      }
      for (std::int32_t k = low[2]; k <= high[2]; ++k)
        for (std::int32_t j = low[1]; j <= high[1]; ++j)
          for (std::int32_t i = low[0]; i <= high[0]; ++i) visit(n, key(i, j, k), box(i, j, k), p);
    }
  }

  void fill(const Cloud& cloud, float radius) {
    const std::size_t cells = key(0, 0, view_.size[2]);
    // What the nearest point can be at most, wherever in the cell the query lies.
    std::vector<float> bound(cells, radius * radius);
    for_each_reach(cloud, radius, [&](std::size_t, std::size_t c, const Box& b, const float* p) {
      bound[c] = std::min(bound[c], farthest_squared(b, p));
    });
    const auto qualifies = [&](std::size_t c, const Box& b, const float* p) {
      return nearest_squared(b, p) <= bound[c] * (1 + kSlack);
    };
    std::vector<std::uint32_t> count(cells, 0);
    for_each_reach(cloud, radius, [&](std::size_t, std::size_t c, const Box& b, const float* p) {
      count[c] += qualifies(c, b, p);
    });

    begin_.resize(cells + 1);
    std::size_t total = 0;
    for (std::size_t c = 0; c < cells; ++c) {
      begin_[c] = static_cast<std::uint32_t>(total);
      total += (count[c] + kLanes - 1) / kLanes * kLanes;
    }
    begin_[cells] = static_cast<std::uint32_t>(total);
    x_.assign(total, kFar);
    y_.assign(total, kFar);
    z_.assign(total, kFar);
    index_.assign(total, -1);
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for_each_reach(cloud, radius, [&](std::size_t n, std::size_t c, const Box& b, const float* p) {
      if (!qualifies(c, b, p)) return;
      const std::uint32_t k = next[c]++;
      x_[k] = p[0];
      y_[k] = p[1];
      z_[k] = p[2];
      index_[k] = static_cast<std::int32_t>(n);
    });
  }

  const Kernels& kernels_;
  GridView view_{};
  float cell_ = 0;
  std::vector<std::uint32_t> begin_;  // per cell, and one past the last
  std::vector<float> x_, y_, z_;      // candidates, cell by cell
  std::vector<std::int32_t> index_;   // their rows in the cloud, -1 for padding
};

}  // namespace

std::unique_ptr<Neighbors> make_candidate_grid(const Cloud& cloud, float radius, float cell,
                                               const Kernels& kernels) {
  return std::make_unique<CandidateGrid>(cloud, radius, cell, kernels);
}

}  // namespace emtr
