#pragma once

#include <emtr/emtr.h>

#include <memory>

#include "input.h"

namespace fuzz {

/// Correspondences for the settings. Their memory ends with the last one, so that a byte read too
/// many is seen. Most rows exist, and many pair a point with itself.
class AnyCorrespondences {
 public:
  AnyCorrespondences(Input& input, std::size_t source, std::size_t target) {
    if (input.ConsumeIntegralInRange(0, 3) != 3) return;
    count_ = input.ConsumeIntegralInRange<std::size_t>(0, 40);
    rows_.reset(new std::int32_t[2 * count_]);
    const bool same = input.ConsumeBool();
    for (std::size_t i = 0; i < count_; ++i) {
      rows_[2 * i] = row(input, source);
      rows_[2 * i + 1] = same ? rows_[2 * i] : row(input, target);
    }
    if (input.ConsumeIntegralInRange(0, 15) == 15) rows_.reset();  // a count without an array
  }

  void add_to(emtr_settings& settings) const {
    settings.correspondences = rows_.get();
    settings.correspondence_count = count_;
  }

 private:
  static std::int32_t row(Input& input, std::size_t rows) {
    if (input.ConsumeIntegralInRange(0, 255) == 255) return input.ConsumeIntegral<std::int32_t>();
    const auto most = static_cast<std::int32_t>(rows);
    return most ? input.ConsumeIntegral<std::uint8_t>() % most : 0;
  }

  std::unique_ptr<std::int32_t[]> rows_;
  std::size_t count_ = 0;
};

}  // namespace fuzz
