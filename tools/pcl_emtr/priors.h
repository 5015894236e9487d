#pragma once

#include <emtr/emtr.h>

#include <CLI/CLI.hpp>
#include <array>
#include <string>

namespace cli {

/// What is known of the pose and takes more than one number: --axis and --translation-bounds. Those
/// of one number are among the SettingOptions.
class Priors {
 public:
  explicit Priors(CLI::App& app);

  /// Sets what the user gave; throws UsageFailure for what is no number.
  void apply(emtr_settings& settings) const;

 private:
  CLI::Option* axis_option_;
  CLI::Option* bounds_option_;
  std::array<std::string, 3> axis_;  // as texts, because CLI11 reads numbers by the locale
  std::array<std::string, 6> bounds_;
};

}  // namespace cli
