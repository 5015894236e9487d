#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include "failure.h"
#include "text/numbers.h"

namespace cli {

/// An option of several numbers. Its words are kept as text, because CLI11 parses numbers by the
/// locale.
template <std::size_t Count>
struct NumbersOption {
  CLI::Option* option = nullptr;
  std::array<std::string, Count> words;

  bool given() const { return option->count() > 0; }

  /// Returns the i-th number; throws UsageFailure unless the word is a finite number.
  double operator[](std::size_t i) const {
    const auto value = parse_real(words[i]);
    if (!value || !std::isfinite(*value))
      throw UsageFailure(option->get_name() + ": '" + words[i] +
                         "' is not a finite number, expected " + option->get_type_name());
    return *value;
  }
};

}  // namespace cli
