#pragma once

#include <cstdint>
#include <vector>

#include "correspondences/descriptor_rows.h"
#include "kernels/kernels.h"

namespace emtr {

/// Holds the k nearest of each of n items: the j-th of item i lies at [j * n + i]. There may be
/// more items than descriptors; those have no neighbors.
struct Nearest {
  std::size_t n = 0, k = 0;
  std::vector<float> squared;
  std::vector<std::int32_t> index;  ///< -1 where there are fewer

  Nearest() = default;
  Nearest(std::size_t items, std::size_t nearest);

  NearestLists lists(std::size_t first = 0) {
    return {squared.data() + first, index.data() + first, n, k};
  }
  bool among_first(std::size_t count, std::size_t item, std::int32_t other) const;
  float farthest(std::size_t item) const { return squared[(k - 1) * n + item]; }
  /// Merges what each thread has found, if it has. Orders by distance and index, so that it does
  /// not matter which thread found what.
  void merge(const std::vector<Nearest>& by_thread);

 private:
  void merge(const Nearest& other);
};

/// The k nearest on the other side for the descriptors of both sides, by position in the rows.
struct NearestBothWays {
  Nearest forward, backward;
};

/// Returns the rows of the points that have a descriptor.
std::vector<std::int32_t> rows_with_descriptor(const DescriptorRows& features);

/// Compares all with all.
NearestBothWays compare_all_descriptors(const DescriptorRows& source,
                                        const std::vector<std::int32_t>& source_rows,
                                        const DescriptorRows& target,
                                        const std::vector<std::int32_t>& target_rows, std::size_t k,
                                        const Kernels& kernels, int threads);

/// Returns the same bits. Pairs that are too far apart in a few principal coordinates are left out,
/// most of all with blocks of descriptors that are near each other.
NearestBothWays find_nearest_descriptors(const DescriptorRows& source,
                                         const std::vector<std::int32_t>& source_rows,
                                         const DescriptorRows& target,
                                         const std::vector<std::int32_t>& target_rows,
                                         std::size_t k, const Kernels& kernels, int threads);

}  // namespace emtr
