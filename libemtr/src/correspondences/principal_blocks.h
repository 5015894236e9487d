#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <vector>

#include "correspondences/descriptor_rows.h"
#include "kernels/kernels.h"

namespace emtr {

/// An orthonormal basis in which a descriptor's first coordinates say the most of it: its distance
/// to another in these alone is a lower bound of their distance, and close to it.
struct PrincipalBasis {
  Eigen::VectorXf mean;
  Eigen::MatrixXf axes;  ///< (dimension, kPrincipal), the largest variance first

  /// Finds the basis of the descriptors of both sides, or of some thousand of them.
  PrincipalBasis(const DescriptorRows& source, const std::vector<std::int32_t>& source_rows,
                 const DescriptorRows& target, const std::vector<std::int32_t>& target_rows);
};

/// Descriptors of one side in blocks of kDescriptorBlock that are near each other.
class PrincipalBlocks {
 public:
  PrincipalBlocks(const DescriptorRows& features, const std::vector<std::int32_t>& rows,
                  const PrincipalBasis& basis);

  std::size_t size() const { return blocks_; }
  std::size_t padded() const { return blocks_ * kDescriptorBlock; }
  /// Returns the position in `rows` for each place; -1 after the last.
  const std::vector<std::int32_t>& order() const { return order_; }
  PrincipalBlock block(std::size_t b) const;
  /// Returns the squared distance between the boxes of two blocks.
  float squared_distance(std::size_t b, const PrincipalBlocks& other, std::size_t o) const;
  /// Tells whether the coordinates bound distances. Otherwise, of numbers that are not finite or
  /// whose squares are not, there are no blocks.
  bool bounds() const;
  /// Returns the largest distance of a descriptor from the basis's origin.
  float largest_norm() const { return largest_norm_; }

 private:
  void split(const Eigen::MatrixXf& coordinates, std::size_t begin, std::size_t end);
  void fill(const DescriptorRows& features, const std::vector<std::int32_t>& rows,
            const Eigen::MatrixXf& coordinates);

  std::size_t blocks_, dimension_;
  float largest_norm_ = std::numeric_limits<float>::infinity();
  std::vector<std::int32_t> order_;
  std::vector<float> values_, principal_;
  std::vector<float> low_, high_;  // boxes, kPrincipal numbers a block
};

}  // namespace emtr
