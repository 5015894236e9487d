#include "correspondences/matching.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "correspondences/nearest_descriptors.h"

namespace emtr {
namespace {

constexpr std::size_t kCrowd = 10;  // nearest ones, whose last tells how common a descriptor is

/// Finds the `wanted` nearest on the other side for the points of both sides.
struct BothWays {
  std::vector<std::int32_t> source, target;  // rows with a descriptor
  Nearest forward, backward;

  BothWays(const DescriptorRows& source_features, const DescriptorRows& target_features,
           std::size_t wanted, const Kernels& kernels, int threads)
      : source(rows_with_descriptor(source_features)),
        target(rows_with_descriptor(target_features)) {
    if (source.empty() || target.empty() || wanted == 0) return;
    NearestBothWays found = find_nearest_descriptors(source_features, source, target_features,
                                                     target, wanted, kernels, threads);
    forward = std::move(found.forward);
    backward = std::move(found.backward);
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
