#include "matching.h"

#include <algorithm>
#include <tuple>

#include "../team.h"

namespace emtr {
namespace {

static_assert(kFeatureSize == kDescriptor);

constexpr std::size_t kRowsOfAPiece = 64;
constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

/// The rows of the points that have a descriptor.
std::vector<std::int32_t> described(const DescriptorRows& features) {
  std::vector<std::int32_t> rows;
  for (std::size_t i = 0; i < features.count; ++i)
    if (features.valid(i)) rows.push_back(static_cast<std::int32_t>(i));
  return rows;
}

std::vector<float> packed(const DescriptorRows& features, const std::vector<std::int32_t>& rows) {
  std::vector<float> out(rows.size() * features.dimension);
  for (std::size_t i = 0; i < rows.size(); ++i)
    std::copy_n(features.row(static_cast<std::size_t>(rows[i])), features.dimension,
                &out[i * features.dimension]);
  return out;
}

/// As the kernels want one of the two sides.
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

/// The k nearest of each of n items.
struct Nearest {
  std::size_t n = 0, k = 0;
  std::vector<float> squared;
  std::vector<std::int32_t> index;

  Nearest() = default;
  Nearest(std::size_t items, std::size_t most)
      : n(items),
        k(most),
        squared(items * most, std::numeric_limits<float>::infinity()),
        index(items * most, -1) {}

  NearestLists lists(std::size_t first = 0) {
    return {squared.data() + first, index.data() + first, n, k};
  }

  bool contains(std::size_t item, std::int32_t other) const {
    for (std::size_t j = 0; j < k; ++j)
      if (index[j * n + item] == other) return true;
    return false;
  }

  /// Takes in what another thread found; by distance and index, so that it does not matter which
  /// thread has seen what.
  void merge(const Nearest& other) {
    std::vector<std::pair<float, std::int32_t>> both(2 * k);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < k; ++j) {
        both[j] = {squared[j * n + i], index[j * n + i]};
        both[k + j] = {other.squared[j * n + i], other.index[j * n + i]};
      }
      std::sort(both.begin(), both.end());
      for (std::size_t j = 0; j < k; ++j) std::tie(squared[j * n + i], index[j * n + i]) = both[j];
    }
  }
};

}  // namespace

std::vector<Correspondence> match_mutual(const DescriptorRows& source, const DescriptorRows& target,
                                         int k, std::size_t most, const Kernels& kernels,
                                         int threads) {
  const std::vector<std::int32_t> s = described(source), t = described(target);
  if (s.empty() || t.empty() || k < 1) return {};
  const std::vector<float> rows = packed(source, s);
  const Blocks columns(target, t);
  const auto wanted = static_cast<std::size_t>(k);

  Nearest forward(s.size(), wanted);
  std::vector<Nearest> found(static_cast<std::size_t>(threads));  // backward, by thread
  const std::size_t pieces = (s.size() + kRowsOfAPiece - 1) / kRowsOfAPiece;
  Team::with(threads, [&](Team& team) {
    team.parallel(pieces, [&](std::size_t piece, std::size_t thread) {
      Nearest& backward = found[thread];
      if (backward.n == 0) backward = Nearest(columns.padded(), wanted);
      const std::size_t first = piece * kRowsOfAPiece;
      kernels.nearest_descriptors(
          &rows[first * source.dimension], std::min(kRowsOfAPiece, s.size() - first),
          static_cast<std::int32_t>(first), columns.view(), forward.lists(first), backward.lists());
    });
  });
  Nearest backward(columns.padded(), wanted);
  for (const Nearest& part : found)
    if (part.n != 0) backward.merge(part);

  std::vector<std::tuple<float, std::int32_t, std::int32_t>> mutual;
  for (std::size_t i = 0; i < s.size(); ++i)
    for (std::size_t j = 0; j < wanted; ++j) {
      const std::int32_t other = forward.index[j * forward.n + i];
      if (other < 0) break;
      const auto column = static_cast<std::size_t>(other);
      if (backward.contains(column, static_cast<std::int32_t>(i)))
        mutual.emplace_back(forward.squared[j * forward.n + i], s[i], t[column]);
    }
  std::sort(mutual.begin(), mutual.end());
  mutual.resize(std::min(mutual.size(), most));
  std::vector<Correspondence> out;
  out.reserve(mutual.size());
  for (const auto& [distance, i, j] : mutual) out.push_back({i, j});
  return out;
}

}  // namespace emtr
