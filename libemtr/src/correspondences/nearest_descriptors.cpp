#include "correspondences/nearest_descriptors.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include "util/constants.h"
#include "util/thread_team.h"

namespace emtr {
namespace {

static_assert(kFeatureSize == kDescriptor);

constexpr std::size_t kNumbersPerJob = 64 * 352;  // of the rows that one job compares with all

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

}  // namespace

Nearest::Nearest(std::size_t items, std::size_t nearest)
    : n(items),
      k(nearest),
      squared(items * nearest, std::numeric_limits<float>::infinity()),
      index(items * nearest, -1) {}

bool Nearest::among_first(std::size_t count, std::size_t item, std::int32_t other) const {
  for (std::size_t j = 0; j < count; ++j)
    if (index[j * n + item] == other) return true;
  return false;
}

void Nearest::merge(const std::vector<Nearest>& by_thread) {
  for (const Nearest& part : by_thread)
    if (part.n != 0) merge(part);
}

void Nearest::merge(const Nearest& other) {
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

std::vector<std::int32_t> rows_with_descriptor(const DescriptorRows& features) {
  std::vector<std::int32_t> rows;
  for (std::size_t i = 0; i < features.count; ++i)
    if (features.valid(i)) rows.push_back(static_cast<std::int32_t>(i));
  return rows;
}

NearestBothWays compare_all_descriptors(const DescriptorRows& source,
                                        const std::vector<std::int32_t>& source_rows,
                                        const DescriptorRows& target,
                                        const std::vector<std::int32_t>& target_rows, std::size_t k,
                                        const Kernels& kernels, int threads) {
  const std::vector<float> rows = pack(source, source_rows);
  const Blocks columns(target, target_rows);
  NearestBothWays out{Nearest(source_rows.size(), k), Nearest(columns.padded(), k)};
  std::vector<Nearest> found(static_cast<std::size_t>(threads));  // backward, by thread
  const std::size_t rows_per_job =
      std::clamp<std::size_t>(kNumbersPerJob / source.dimension, 4, 64);
  const std::size_t jobs = (source_rows.size() + rows_per_job - 1) / rows_per_job;
  ThreadTeam::with(threads, [&](ThreadTeam& team) {
    team.parallel(jobs, [&](std::size_t job, std::size_t thread) {
      Nearest& mine = found[thread];
      if (mine.n == 0) mine = Nearest(columns.padded(), k);
      const std::size_t first = job * rows_per_job;
      kernels.nearest_descriptors(
          &rows[first * source.dimension], std::min(rows_per_job, source_rows.size() - first),
          static_cast<std::int32_t>(first), columns.view(), out.forward.lists(first), mine.lists());
    });
  });
  out.backward.merge(found);
  return out;
}

}  // namespace emtr
