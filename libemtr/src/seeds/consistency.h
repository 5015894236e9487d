#pragma once

#include <cstdint>
#include <vector>

#include "correspondences/correspondence.h"
#include "geometry/cloud.h"
#include "geometry/rigid.h"

namespace emtr {

/// Tells which correspondences can be correct together: a rigid motion keeps lengths, so two
/// correct ones have | |p_j - p_i| - |q_j - q_i| | below the noise. Stores one bit for each pair.
class Consistency {
 public:
  Consistency(const Cloud& source, const Cloud& target,
              const std::vector<Correspondence>& correspondences, double threshold,
              const Kernels& kernels, int threads);

  std::size_t size() const { return n_; }
  bool operator()(std::size_t i, std::size_t j) const { return row(i)[j / 64] >> (j % 64) & 1; }
  /// Returns the number of others with which correspondence i is consistent.
  std::size_t degree(std::size_t i) const { return degree_[i]; }
  /// Returns the second order (SC2): the number of others that are consistent with both.
  std::size_t common(std::size_t i, std::size_t j) const {
    return kernels_.count_common(row(i), row(j), words_);
  }

  /// Counts those before j that are consistent with both.
  std::size_t common_before(std::size_t i, std::size_t j) const {
    const std::uint64_t last = row(i)[j / 64] & row(j)[j / 64];
    return kernels_.count_common(row(i), row(j), j / 64) +
           static_cast<std::size_t>(
               __builtin_popcountll(last & ((std::uint64_t{1} << (j % 64)) - 1)));
  }

  /// Writes the bits of the correspondences that a pose brings within the distance, and returns how
  /// many they are.
  std::size_t inliers(const Rigid& pose, double squared_distance, std::uint64_t* bits) const;

  /// Counts those of a set that are consistent with correspondence i.
  std::size_t count_common(const std::uint64_t* set, std::size_t i) const {
    return kernels_.count_common(set, row(i), words_);
  }
  /// Returns the bits of correspondence i: which others are consistent with it.
  const std::uint64_t* row(std::size_t i) const { return &bits_[i * words_]; }
  std::size_t words() const { return words_; }
  /// Calls visit(j) for each j >= first that is consistent with correspondence i, in order.
  template <class Visit>
  void for_each_consistent(std::size_t i, std::size_t first, const Visit& visit) const {
    for (std::size_t word = first / 64; word < words_; ++word) {
      std::uint64_t bits = row(i)[word];
      if (word == first / 64) bits &= ~std::uint64_t{0} << (first % 64);
      for (; bits; bits &= bits - 1)
        visit(64 * word + static_cast<std::size_t>(__builtin_ctzll(bits)));
    }
  }

  const Cloud& p() const { return p_; }  ///< source points, one for each correspondence, padded
  const Cloud& q() const { return q_; }  ///< target points

 private:
  const Kernels& kernels_;
  std::size_t n_, words_;
  Cloud p_, q_;
  std::vector<std::uint64_t> bits_;
  std::vector<std::size_t> degree_;
};

}  // namespace emtr
