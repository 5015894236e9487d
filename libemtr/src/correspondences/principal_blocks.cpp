#include "correspondences/principal_blocks.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>
#include <numeric>

namespace emtr {
namespace {

constexpr std::size_t kSample = 500;  // descriptors of a side that the basis is made of
constexpr Eigen::Index kSplitAxes = 8;
constexpr float kLargestNorm = 1e15f;  // whose square is finite

void gather(const DescriptorRows& features, const std::vector<std::int32_t>& rows,
            std::vector<Eigen::VectorXd>& out) {
  const std::size_t step = 1 + rows.size() / kSample;
  for (std::size_t i = 0; i < rows.size(); i += step) {
    const Eigen::Map<const Eigen::VectorXf> descriptor(
        features.row(static_cast<std::size_t>(rows[i])),
        static_cast<Eigen::Index>(features.dimension));
    out.emplace_back(descriptor.cast<double>());
  }
}

}  // namespace

PrincipalBasis::PrincipalBasis(const DescriptorRows& source,
                               const std::vector<std::int32_t>& source_rows,
                               const DescriptorRows& target,
                               const std::vector<std::int32_t>& target_rows) {
  std::vector<Eigen::VectorXd> sample;
  gather(source, source_rows, sample);
  gather(target, target_rows, sample);
  const auto dimension = static_cast<Eigen::Index>(source.dimension);
  Eigen::VectorXd center = Eigen::VectorXd::Zero(dimension);
  for (const Eigen::VectorXd& d : sample) center += d;
  center /= static_cast<double>(sample.size());
  Eigen::MatrixXd scatter = Eigen::MatrixXd::Zero(dimension, dimension);
  for (Eigen::VectorXd& d : sample) {
    d -= center;
    scatter += d * d.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scatter);
  constexpr auto kept = static_cast<Eigen::Index>(kPrincipal);
  mean = center.cast<float>();
  axes = solver.eigenvectors().rightCols(kept).rowwise().reverse().cast<float>();
}

PrincipalBlocks::PrincipalBlocks(const DescriptorRows& features,
                                 const std::vector<std::int32_t>& rows, const PrincipalBasis& basis)
    : blocks_((rows.size() + kDescriptorBlock - 1) / kDescriptorBlock),
      dimension_(features.dimension),
      order_(rows.size()) {
  const auto dimension = static_cast<Eigen::Index>(dimension_);
  Eigen::MatrixXf centered(dimension, static_cast<Eigen::Index>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    centered.col(static_cast<Eigen::Index>(i)) =
        Eigen::Map<const Eigen::VectorXf>(features.row(static_cast<std::size_t>(rows[i])),
                                          dimension) -
        basis.mean;
  if (!centered.allFinite()) return;
  largest_norm_ = centered.colwise().norm().maxCoeff();
  if (!bounds()) return;
  const Eigen::MatrixXf coordinates = basis.axes.transpose() * centered;
  std::iota(order_.begin(), order_.end(), 0);
  split(coordinates, 0, rows.size());
  fill(features, rows, coordinates);
}

bool PrincipalBlocks::bounds() const { return largest_norm_ < kLargestNorm; }

/// Splits at the median of the widest axis, so that only the last block is not full.
void PrincipalBlocks::split(const Eigen::MatrixXf& coordinates, std::size_t begin,
                            std::size_t end) {
  if (end - begin <= kDescriptorBlock) return;
  Eigen::Array<float, kSplitAxes, 1> low, high;
  low.setConstant(std::numeric_limits<float>::infinity());
  high = -low;
  for (std::size_t i = begin; i < end; ++i) {
    const auto x = coordinates.col(order_[i]).head<kSplitAxes>().array();
    low = low.min(x);
    high = high.max(x);
  }
  Eigen::Index axis = 0;
  (high - low).maxCoeff(&axis);
  const std::size_t blocks = (end - begin + kDescriptorBlock - 1) / kDescriptorBlock;
  const std::size_t middle = begin + (blocks + 1) / 2 * kDescriptorBlock;
  const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end), [&](std::int32_t a, std::int32_t b) {
    return coordinates(axis, a) < coordinates(axis, b);
  });
  split(coordinates, begin, middle);
  split(coordinates, middle, end);
}

void PrincipalBlocks::fill(const DescriptorRows& features, const std::vector<std::int32_t>& rows,
                           const Eigen::MatrixXf& coordinates) {
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  values_.assign(padded() * dimension_, kNaN);
  principal_.assign(padded() * kPrincipal, kNaN);
  low_.assign(blocks_ * kPrincipal, kInfinity);
  high_.assign(blocks_ * kPrincipal, -kInfinity);
  for (std::size_t i = 0; i < order_.size(); ++i) {
    const std::size_t b = i / kDescriptorBlock, lane = i % kDescriptorBlock;
    const auto position = static_cast<std::size_t>(order_[i]);
    const float* from = features.row(static_cast<std::size_t>(rows[position]));
    for (std::size_t d = 0; d < dimension_; ++d)
      values_[(b * dimension_ + d) * kDescriptorBlock + lane] = from[d];
    for (std::size_t d = 0; d < kPrincipal; ++d) {
      const float x = coordinates(static_cast<Eigen::Index>(d), order_[i]);
      principal_[(b * kPrincipal + d) * kDescriptorBlock + lane] = x;
      low_[b * kPrincipal + d] = std::min(low_[b * kPrincipal + d], x);
      high_[b * kPrincipal + d] = std::max(high_[b * kPrincipal + d], x);
    }
  }
  order_.resize(padded(), -1);
}

PrincipalBlock PrincipalBlocks::block(std::size_t b) const {
  return {&values_[b * dimension_ * kDescriptorBlock],
          &principal_[b * kPrincipal * kDescriptorBlock],
          &low_[b * kPrincipal],
          &high_[b * kPrincipal],
          &order_[b * kDescriptorBlock],
          b * kDescriptorBlock};
}

float PrincipalBlocks::squared_distance(std::size_t b, const PrincipalBlocks& other,
                                        std::size_t o) const {
  using Coordinates = Eigen::Map<const Eigen::Array<float, kPrincipal, 1>>;
  const Coordinates low(&low_[b * kPrincipal]), high(&high_[b * kPrincipal]),
      other_low(&other.low_[o * kPrincipal]), other_high(&other.high_[o * kPrincipal]);
  return (other_low - high).max(low - other_high).max(0.0f).square().sum();
}

}  // namespace emtr
