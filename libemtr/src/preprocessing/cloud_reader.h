#pragma once

#include <emtr/emtr.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <optional>
#include <string>

#include "preprocessing/ball.h"
#include "util/constants.h"
#include "util/enum_number.h"
#include "util/error.h"

namespace emtr {

/// Reads the user's memory where it is, block by block. Sums over a cloud are made for each block
/// and added in order, so that they do not depend on which thread makes which block.
class CloudReader {
 public:
  static constexpr std::size_t kBlock = 65536;  ///< a place in a block fits into 16 bits

  /// Throws Error, naming the cloud, on a view that cannot be read.
  CloudReader(const emtr_cloud& cloud, const std::string& name)
      : first_(static_cast<const char*>(cloud.points)),
        count_(cloud.count),
        single_(number_of(cloud.scalar) == EMTR_FLOAT32) {
    if (!single_ && number_of(cloud.scalar) != EMTR_FLOAT64)
      throw Error(EMTR_ERROR_ARGUMENT, name + ": scalar must be EMTR_FLOAT32 or EMTR_FLOAT64");
    if (!cloud.points && cloud.count) throw Error(EMTR_ERROR_ARGUMENT, name + ": points is null");
    const std::size_t packed = 3 * (single_ ? sizeof(float) : sizeof(double));
    if (cloud.stride && cloud.stride < packed)
      throw Error(EMTR_ERROR_ARGUMENT, name + ": stride is " + std::to_string(cloud.stride) +
                                           " bytes, expected 0 or at least " +
                                           std::to_string(packed));
    stride_ = cloud.stride ? cloud.stride : packed;
  }

  std::size_t count() const { return count_; }
  std::size_t blocks() const { return (count_ + kBlock - 1) / kBlock; }

  /// Leaves out all points outside of a ball from now on, as if they were not finite.
  void keep_within(const Ball& ball) { within_ = ball; }

  /// Calls visit(i, p) for each finite point of a block, in order, with its place in the block and
  /// its coordinates, a const double[3].
  template <class Visit>
  void each_finite(std::size_t block, const Visit& visit) const {
    const std::size_t n = std::min(kBlock, count_ - block * kBlock);
    const auto all = [&](auto scalar) {
      for (std::size_t i = 0; i < n; ++i) {
        double p[3];
        if (read<decltype(scalar)>(block * kBlock + i, p)) visit(i, p);
      }
    };
    single_ ? all(float{}) : all(double{});
  }

  /// Reads one point; returns false when it is not finite or left out.
  bool read(std::size_t index, double p[3]) const {
    return single_ ? read<float>(index, p) : read<double>(index, p);
  }

  /// Fetches a point that is read soon.
  void prefetch(std::size_t index) const { __builtin_prefetch(first_ + index * stride_); }

  /// Reads a direction and makes it of unit length; writes NaN when it is not finite or has no
  /// length.
  void read_direction(std::size_t index, float n[3]) const {
    double v[3];
    const bool finite = read(index, v);
    const double length = std::hypot(v[0], v[1], v[2]);
    for (int k = 0; k < 3; ++k)
      n[k] = finite && length > 0 ? static_cast<float>(v[k] / length) : kNone;
  }

 private:
  template <class Scalar>
  bool read(std::size_t index, double p[3]) const {
    Scalar raw[3];
    std::memcpy(raw, first_ + index * stride_, sizeof raw);  // the user may not have aligned it
    std::copy_n(raw, 3, p);
    if (!(std::isfinite(raw[0]) && std::isfinite(raw[1]) && std::isfinite(raw[2]))) return false;
    return !within_ || within_->contains(p);
  }

  const char* first_;
  std::size_t count_, stride_ = 0;
  bool single_;
  std::optional<Ball> within_;
};

}  // namespace emtr
