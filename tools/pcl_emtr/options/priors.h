#pragma once

#include <emtr/emtr.h>

#include <CLI/CLI.hpp>

#include "options/numbers_option.h"

namespace cli {

/// The priors of more than one number: --axis and --translation-bounds. SettingOptions has those of
/// one number.
class Priors {
 public:
  explicit Priors(CLI::App& app);

  /// Sets what the user gave; throws UsageFailure for a word that is not a number.
  void apply(emtr_settings& settings) const;

 private:
  NumbersOption<3> axis_;
  NumbersOption<6> bounds_;
};

}  // namespace cli
