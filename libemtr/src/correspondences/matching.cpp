#include "correspondences/matching.h"

#include <algorithm>
#include <tuple>

#include "util/constants.h"
#include "util/thread_team.h"

namespace emtr {
namespace {

static_assert(kFeatureSize == kDescriptor);

constexpr std::size_t kNumbersPerJob = 64 * 352;  // of the rows that one job compares with all
constexpr std::size_t kCrowd = 10;  // nearest ones, whose last tells how common a descriptor is

/// Returns the rows of the points that have a descriptor.
std::vector<std::int32_t> rows_with_descriptor(const DescriptorRows& features) {
  std::vector<std::int32_t> rows;
  for (std::size_t i = 0; i < features.count; ++i)
    if (features.valid(i)) rows.push_back(static_cast<std::int32_t>(i));
  return rows;
}

std::vector<float> pack(const DescriptorRows& features, const std::vector<std::int32_t>& rows) {
  std::vector<float> out(rows.size() * features.dimension);
  for (std::size_t i = 0; i < rows.size(); ++i)
    std::copy_n(features.row(static_cast<std::size_t>(rows[i])), features.dimension,
                &out[i * features.dimension]);
  return out;
}

/// Lays out the descriptors of one side in blocks, as the kernels read them.
class Blocks {
 public:
  Blocks(const DescriptorRows& features, const std::vector<std::int32_t>& rows)
      : blocks_((rows.size() + kDescriptorBlock - 1) / kDescriptorBlock),
        dimension_(features.dimension),
        values_(blocks_ * dimension_ * kDescriptorBlock, kNone) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const float* from = features.row(static_cast<std::size_t>(rows[i]));
      float* to = &values_[i / kDescriptorBlock * dimension_ * kDescriptorBlock];
      for (std::size_t d = 0; d < dimension_; ++d)
        to[d * kDescriptorBlock + i % kDescriptorBlock] = from[d];
    }
  }
  DescriptorBlocks view() const { return {values_.data(), blocks_, dimension_}; }
  std::size_t padded() const { return blocks_ * kDescriptorBlock; }

 private:
  std::size_t blocks_, dimension_;
  std::vector<float> values_;
};

/// Holds the k nearest of each of n items.
struct Nearest {
  std::size_t n = 0, k = 0;
  std::vector<float> squared;
  std::vector<std::int32_t> index;

  Nearest() = default;
  Nearest(std::size_t items, std::size_t nearest)
      : n(items),
        k(nearest),
        squared(items * nearest, std::numeric_limits<float>::infinity()),
        index(items * nearest, -1) {}

  NearestLists lists(std::size_t first = 0) {
    return {squared.data() + first, index.data() + first, n, k};
  }

  bool among_first(std::size_t count, std::size_t item, std::int32_t other) const {
    for (std::size_t j = 0; j < count; ++j)
      if (index[j * n + item] == other) return true;
    return false;
  }

  float farthest(std::size_t item) const { return squared[(k - 1) * n + item]; }

  /// Merges the lists of another thread. Orders by distance and index, so that it does not matter
  /// which thread found what.
  void merge(const Nearest& other) {
    std::vector<std::pair<float, std::int32_t>> both(2 * k);
    for (std::size_t i = 0; i < n; ++i) {
      check_cancelled_each(i, 10);
      for (std::size_t j = 0; j < k; ++j) {
        both[j] = {squared[j * n + i], index[j * n + i]};
        both[k + j] = {other.squared[j * n + i], other.index[j * n + i]};
      }
      std::sort(both.begin(), both.end());
      for (std::size_t j = 0; j < k; ++j) std::tie(squared[j * n + i], index[j * n + i]) = both[j];
    }
  }
};

/// Finds the `wanted` nearest on the other side for the points of both sides.
struct BothWays {
  std::vector<std::int32_t> source, target;  // rows with a descriptor
  Nearest forward, backward;

  BothWays(const DescriptorRows& source_features, const DescriptorRows& target_features,
           std::size_t wanted, const Kernels& kernels, int threads)
      : source(rows_with_descriptor(source_features)),
        target(rows_with_descriptor(target_features)) {
    if (source.empty() || target.empty() || wanted == 0) return;
    const std::vector<float> rows = pack(source_features, source);
    const Blocks columns(target_features, target);
    forward = Nearest(source.size(), wanted);
    std::vector<Nearest> found(static_cast<std::size_t>(threads));  // backward, by thread
    const std::size_t rows_per_job =
        std::clamp<std::size_t>(kNumbersPerJob / source_features.dimension, 4, 64);
    const std::size_t jobs = (source.size() + rows_per_job - 1) / rows_per_job;
    ThreadTeam::with(threads, [&](ThreadTeam& team) {
      team.parallel(jobs, [&](std::size_t job, std::size_t thread) {
        Nearest& mine = found[thread];
        if (mine.n == 0) mine = Nearest(columns.padded(), wanted);
        const std::size_t first = job * rows_per_job;
        kernels.nearest_descriptors(
            &rows[first * source_features.dimension], std::min(rows_per_job, source.size() - first),
            static_cast<std::int32_t>(first), columns.view(), forward.lists(first), mine.lists());
      });
    });
    backward = Nearest(columns.padded(), wanted);
    for (const Nearest& part : found)
      if (part.n != 0) backward.merge(part);
  }

  /// Returns the pairs that are among the first k of each other, the smallest
  /// `order(squared, row, column)` first.
  template <class Order>
  std::vector<Correspondence> mutual(std::size_t k, std::size_t max_count, const Order& order,
                                     std::size_t* count = nullptr) const {
    std::vector<std::tuple<float, std::int32_t, std::int32_t>> found;
    for (std::size_t i = 0; i < forward.n; ++i)
      for (std::size_t j = 0; j < k; ++j) {
        const std::int32_t other = forward.index[j * forward.n + i];
        if (other < 0) break;
        const auto column = static_cast<std::size_t>(other);
        if (backward.among_first(k, column, static_cast<std::int32_t>(i)))
          found.emplace_back(order(forward.squared[j * forward.n + i], i, column), source[i],
                             target[column]);
      }
    if (count) *count = found.size();
    std::sort(found.begin(), found.end());
    found.resize(std::min(found.size(), max_count));
    std::vector<Correspondence> out;
    out.reserve(found.size());
    for (const auto& [key, i, j] : found) out.push_back({i, j});
    return out;
  }
};

}  // namespace

std::vector<Correspondence> match_mutual(const DescriptorRows& source, const DescriptorRows& target,
                                         int k, std::size_t max_count, const Kernels& kernels,
                                         int threads, std::size_t* found) {
  const auto wanted = static_cast<std::size_t>(std::max(k, 0));
  const BothWays near(source, target, wanted, kernels, threads);
  return near.mutual(
      wanted, max_count, [](float squared, std::size_t, std::size_t) { return squared; }, found);
}

std::vector<Correspondence> match_distinctive(const DescriptorRows& source,
                                              const DescriptorRows& target, int k,
                                              std::size_t max_count, const Kernels& kernels,
                                              int threads) {
  const auto wanted = static_cast<std::size_t>(std::max(k, 0));
  const BothWays near(source, target, std::max(wanted, kCrowd), kernels, threads);
  return near.mutual(wanted, max_count, [&](float squared, std::size_t row, std::size_t column) {
    const float f = near.forward.farthest(row), b = near.backward.farthest(column);
    return f > 0 && b > 0 ? (squared / f) * (squared / b) : 1.0f;
  });
}

}  // namespace emtr
