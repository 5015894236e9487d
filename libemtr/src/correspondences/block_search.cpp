#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "correspondences/nearest_descriptors.h"
#include "correspondences/principal_blocks.h"
#include "util/thread_team.h"

namespace emtr {
namespace {

constexpr std::size_t kFirstBlocks = 2;   // of the other side, compared before all others
constexpr std::size_t kFewPairs = 40000;  // are compared all with all: the blocks cost more

/// Returns the bound for descriptors whose norm is at most `norm`. A coordinate is rounded by at
/// most dimension * 2^-24 of it, so that of all 16 the difference is off by e = 4.8e-7 * dimension
/// of it; and (s + e)^2 <= 1.001 s^2 + 1001 e^2.
DistanceBound bound_of(float norm, std::size_t dimension) {
  const float e = 5e-7f * static_cast<float>(dimension) * norm;
  return {1.0011f, 1001 * e * e + std::numeric_limits<float>::min()};
}

class BlockSearch {
 public:
  BlockSearch(const PrincipalBlocks& rows, const PrincipalBlocks& columns, std::size_t dimension,
              std::size_t k, const Kernels& kernels, std::size_t threads)
      : rows_(rows),
        columns_(columns),
        dimension_(dimension),
        kernels_(kernels),
        bound_(bound_of(std::max(rows.largest_norm(), columns.largest_norm()), dimension)),
        forward_(rows.padded(), k),
        backward_(threads),
        known_(columns.padded(), std::numeric_limits<float>::infinity()) {}

  void run(ThreadTeam& team) {
    choose_first_blocks(team);
    team.parallel(rows_.size(), [&](std::size_t row, std::size_t thread) {
      for (const std::uint32_t column : first_[row]) compare(row, column, lists_of(thread));
    });
    // What one thread has found for a column is known to all from here on.
    for (const Nearest& part : backward_)
      for (std::size_t i = 0; i < part.n; ++i) known_[i] = std::min(known_[i], part.farthest(i));
    for (std::size_t c = 0; c < columns_.size(); ++c)
      for (std::size_t i = 0; i < kDescriptorBlock; ++i)
        if (columns_.block(c).index[i] >= 0)
          largest_known_[c] = std::max(largest_known_[c], known_[c * kDescriptorBlock + i]);
    team.parallel(rows_.size(), [&](std::size_t row, std::size_t thread) {
      compare_rest(row, lists_of(thread));
    });
  }

  /// Returns what was found by position in the rows.
  NearestBothWays result() const {
    Nearest backward(columns_.padded(), forward_.k);
    backward.merge(backward_);
    return {by_position(forward_, rows_), by_position(backward, columns_)};
  }

 private:
  Nearest& lists_of(std::size_t thread) {
    if (backward_[thread].n == 0) backward_[thread] = Nearest(columns_.padded(), forward_.k);
    return backward_[thread];
  }

  /// Each block with the nearest ones of the other side: then most lists are nearly right at once.
  void choose_first_blocks(ThreadTeam& team) {
    first_ = nearest_blocks(rows_, columns_, team);
    const auto of_columns = nearest_blocks(columns_, rows_, team);
    for (std::size_t column = 0; column < columns_.size(); ++column)
      for (const std::uint32_t row : of_columns[column])
        first_[row].push_back(static_cast<std::uint32_t>(column));
    for (std::vector<std::uint32_t>& columns : first_) {
      std::sort(columns.begin(), columns.end());
      columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
    }
  }

  /// Returns the kFirstBlocks of `b` that are nearest to each block of `a`.
  static std::vector<std::vector<std::uint32_t>> nearest_blocks(const PrincipalBlocks& a,
                                                                const PrincipalBlocks& b,
                                                                ThreadTeam& team) {
    std::vector<std::vector<std::uint32_t>> out(a.size());
    const std::size_t count = std::min(kFirstBlocks, b.size());
    team.parallel(a.size(), [&](std::size_t i, std::size_t) {
      std::vector<std::pair<float, std::uint32_t>> by_distance(b.size());
      for (std::size_t j = 0; j < b.size(); ++j)
        by_distance[j] = {a.squared_distance(i, b, j), static_cast<std::uint32_t>(j)};
      std::partial_sort(by_distance.begin(),
                        by_distance.begin() + static_cast<std::ptrdiff_t>(count),
                        by_distance.end());
      for (std::size_t j = 0; j < count; ++j) out[i].push_back(by_distance[j].second);
    });
    return out;
  }

  void compare(std::size_t row, std::size_t column, Nearest& mine) {
    kernels_.nearest_in_blocks(rows_.block(row), columns_.block(column), dimension_, bound_,
                               known_.data(), forward_.lists(), mine.lists());
  }

  void compare_rest(std::size_t row, Nearest& mine) {
    const float rows_need = largest_of_rows(row);
    auto done = first_[row].begin();
    for (std::size_t column = 0; column < columns_.size(); ++column) {
      if (done != first_[row].end() && *done == column) {
        ++done;
        continue;
      }
      const float needed = std::max(rows_need, largest_known_[column]);
      if (rows_.squared_distance(row, columns_, column) <= needed * bound_.factor + bound_.slack)
        compare(row, column, mine);
    }
  }

  float largest_of_rows(std::size_t row) const {
    float largest = 0;
    for (std::size_t i = row * kDescriptorBlock; i < (row + 1) * kDescriptorBlock; ++i)
      if (rows_.order()[i] >= 0) largest = std::max(largest, forward_.farthest(i));
    return largest;
  }

  static Nearest by_position(const Nearest& by_place, const PrincipalBlocks& blocks) {
    Nearest out(by_place.n, by_place.k);
    for (std::size_t place = 0; place < by_place.n; ++place) {
      if (blocks.order()[place] < 0) continue;
      const auto position = static_cast<std::size_t>(blocks.order()[place]);
      for (std::size_t j = 0; j < out.k; ++j) {
        out.squared[j * out.n + position] = by_place.squared[j * out.n + place];
        out.index[j * out.n + position] = by_place.index[j * out.n + place];
      }
    }
    return out;
  }

  const PrincipalBlocks &rows_, &columns_;
  const std::size_t dimension_;
  const Kernels& kernels_;
  const DistanceBound bound_;
  Nearest forward_;                // by place
  std::vector<Nearest> backward_;  // by thread and place
  std::vector<float> known_;       // upper bounds of what each column has use for
  std::vector<float> largest_known_ = std::vector<float>(columns_.size(), 0);
  std::vector<std::vector<std::uint32_t>> first_;  // column blocks, by row block
};

}  // namespace

NearestBothWays find_nearest_descriptors(const DescriptorRows& source,
                                         const std::vector<std::int32_t>& source_rows,
                                         const DescriptorRows& target,
                                         const std::vector<std::int32_t>& target_rows,
                                         std::size_t k, const Kernels& kernels, int threads) {
  const auto compare_all = [&] {
    return compare_all_descriptors(source, source_rows, target, target_rows, k, kernels, threads);
  };
  if (source.dimension < kPrincipal || source_rows.size() * target_rows.size() < kFewPairs)
    return compare_all();
  const PrincipalBasis basis(source, source_rows, target, target_rows);
  std::optional<PrincipalBlocks> rows, columns;
  parallel_for(2, threads, [&](std::size_t i) {
    if (i == 0)
      rows.emplace(source, source_rows, basis);
    else
      columns.emplace(target, target_rows, basis);
  });
  if (!rows->bounds() || !columns->bounds()) return compare_all();
  BlockSearch search(*rows, *columns, source.dimension, k, kernels,
                     static_cast<std::size_t>(threads));
  ThreadTeam::with(threads, [&](ThreadTeam& team) { search.run(team); });
  return search.result();
}

}  // namespace emtr
