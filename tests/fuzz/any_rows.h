#pragma once

#include <emtr/emtr.h>

#include <cstring>
#include <memory>

#include "input.h"

namespace fuzz {

/// Rows of numbers of either scalar type, with any stride and alignment. Their memory ends with the
/// last number, so that a byte read too many is seen.
class AnyRows {
 public:
  AnyRows() = default;
  AnyRows(Input& input, std::size_t count, std::size_t columns, emtr_scalar scalar)
      : size_(scalar == EMTR_FLOAT32 ? sizeof(float) : sizeof(double)), columns_(columns) {
    const std::size_t packed = columns * size_;
    if (input.ConsumeBool()) stride_ = packed + input.ConsumeIntegralInRange<std::size_t>(0, 9);
    const std::size_t unaligned = input.ConsumeIntegralInRange<std::size_t>(0, 7);
    bytes_ = count ? (count - 1) * step() + packed : 0;
    memory_.reset(new char[unaligned + bytes_]());
    first_ = memory_.get() + unaligned;
  }

  void set(std::size_t row, std::size_t column, double value) {
    char* place = first_ + row * step() + column * size_;
    const auto single = static_cast<float>(value);
    size_ == sizeof single ? std::memcpy(place, &single, size_) : std::memcpy(place, &value, size_);
  }

  double get(std::size_t row, std::size_t column) const {
    const char* place = first_ + row * step() + column * size_;
    double value = 0;
    float single = 0;
    size_ == sizeof single ? std::memcpy(&single, place, size_) : std::memcpy(&value, place, size_);
    return size_ == sizeof single ? single : value;
  }

  /// Fills the memory with any bytes.
  void overwrite(Input& input) { input.ConsumeData(first_, bytes_); }

  const void* data() const { return first_; }
  std::size_t stride() const { return stride_; }  ///< 0: packed

 private:
  std::size_t step() const { return stride_ ? stride_ : columns_ * size_; }

  std::size_t size_ = sizeof(double), columns_ = 0, stride_ = 0, bytes_ = 0;
  std::unique_ptr<char[]> memory_;
  char* first_ = nullptr;
};

}  // namespace fuzz
