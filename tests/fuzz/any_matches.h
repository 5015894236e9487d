#pragma once

#include <emtr/emtr.h>

#include <memory>

#include "input.h"

namespace fuzz {

/// Correspondences for the settings, in a block of memory that ends with the last of them: mostly
/// rows that there are, many of them one point and itself.
class AnyMatches {
 public:
  AnyMatches(Input& input, std::size_t source, std::size_t target) {
    if (input.ConsumeIntegralInRange(0, 3) != 3) return;
    count_ = input.ConsumeIntegralInRange<std::size_t>(0, 40);
    rows_.reset(new std::int32_t[2 * count_]);
    const bool same = input.ConsumeBool();
    for (std::size_t i = 0; i < count_; ++i) {
      rows_[2 * i] = row(input, source);
      rows_[2 * i + 1] = same ? rows_[2 * i] : row(input, target);
    }
    if (input.ConsumeIntegralInRange(0, 15) == 15) rows_.reset();  // a count of nothing
  }

  void set_user_input(emtr_settings& settings) const {
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
